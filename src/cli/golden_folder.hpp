#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>

namespace burin::cli {

inline constexpr std::string_view dump_suffix = ".dump";
inline constexpr std::string_view picture_suffix = ".png";

/// A folder of presets with what they must draw beside them: NAME.toml, NAME.dump and NAME.png. Names are relative to
/// the folder and without suffix, such as "motifs/koch".
struct GoldenFolder {
  std::string path;
  std::vector<std::string> cases;    ///< the presets, sorted
  std::vector<std::string> orphans;  ///< dumps and pictures without a preset, with their suffix, sorted

  std::string file(std::string_view name, std::string_view suffix) const;
};

/// Looks through the folder and all in it, but for hidden files and folders. A problem when it cannot be read.
Result<GoldenFolder> find_goldens(const std::string& path);

}  // namespace burin::cli
