#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/preset/load.hpp>

namespace burin::cli {

/// What the drawing of a preset without a name is called.
inline constexpr std::string_view stdin_stem = "drawing";

/// A preset as found: its text, and the folder its data files are relative to.
struct PresetText {
  preset::Source source;
  std::string stem;    ///< "koch": what its drawings are called
  std::string file;    ///< "koch.toml", "-": without folders
  std::string folder;  ///< empty: the current one
};

/// A preset of the library by name.
struct ShippedPreset {
  std::string name;
  std::string path;
};

/// Whether this word means a file (it has a '/', ends in ".toml" or is "-") instead of a name in the library.
bool is_preset_path(std::string_view word);

/// Reads a file, stdin ("-"), or a preset of the library by its name; a name that the library lacks may also be a file
/// in the current folder.
Result<PresetText> read_preset(const std::string& word);

/// The problems with the lines of the preset that they point to.
Problems with_source(Problems problems, const PresetText& preset);

/// Every preset of the library by name; where a name occurs twice, the folder searched first wins.
std::vector<ShippedPreset> library_presets();
bool is_library_preset(std::string_view name);

/// A file of the library by its name within: "koch.toml", "data/face.png".
std::optional<std::string> library_file(std::string_view name);

/// Where names are looked up, in order: the folders of $BURIN_PATH, $XDG_DATA_HOME/burin/presets (or
/// ~/.local/share/...), share/burin/presets beside the tool's bin folder.
std::vector<std::string> library_folders();

}  // namespace burin::cli
