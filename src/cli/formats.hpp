#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/path/back_end.hpp>

namespace burin::cli {

/// Every back end that this build has: the core's, then Cairo's.
std::vector<const BackEnd*> all_back_ends();

/// The distinct formats, in the order of all_back_ends().
std::vector<std::string_view> format_names();

/// The back end that writes this format: of the name asked for, else the format's default. A problem names what exists.
Result<const BackEnd*> choose_back_end(std::string_view format, const std::optional<std::string>& name);

/// The format of a file name by its suffix, whatever its case. A problem lists the formats.
Result<std::string> format_of_suffix(const std::string& path);

/// What is wrong with a format's name.
Result<Done> check_format(std::string_view format);

/// An option of `draw` that only some formats look at.
struct FormatOption {
  std::string_view option;
  std::vector<std::string_view> formats;
  std::string_view back_end{};  ///< the only one that does; empty: all
};
const std::vector<FormatOption>& format_options();
bool uses_option(const BackEnd& back_end, std::string_view option);

}  // namespace burin::cli
