#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The rules that keep the rooms of src apart, as functions of texts, so that each can be shown to fail. Every rule
/// returns one sentence for each violation, beginning with the file.
namespace burin::architecture {

/// A file of the project: its path from the root ("src/burin/geom/vec2.hpp") and what is in it.
struct File {
  std::string path;
  std::string text;
};

/// A folder of src/burin and the rooms whose headers it may include. What those may use, it may use too.
struct Room {
  std::string_view name;
  std::vector<std::string_view> may_use;
};

/// A library that only one place may name.
struct Library {
  std::string_view header;              ///< how its includes begin: "toml++/"
  std::vector<std::string_view> homes;  ///< path prefixes: "src/burin/preset/"
  bool one_file = true;                 ///< in each home; else any number
};

using Violations = std::vector<std::string>;

/// C++ text with comments, string and character literals blanked; lines stay where they were.
std::string code_only(std::string_view text);

/// The room of a file in src: "geom", "cli", "burin" for the headers above all rooms; empty outside src.
std::string room_of(std::string_view path);

Violations edges(const std::vector<File>& files, const std::vector<Room>& rooms);
/// README's table rows "| `room` |" against the folders and the table; rows with "(coming)" have no folder yet.
Violations map_of_rooms(std::string_view readme, const std::vector<std::string>& folders,
                        const std::vector<Room>& rooms);
Violations libraries(const std::vector<File>& files, const std::vector<Library>& libraries);
/// No library header but the standard library's in the headers that are installed: those that a CMakeLists.txt among
/// `files` has in its FILE_SET.
Violations public_headers(const std::vector<File>& files);
/// sin, cos, exp, log, pow ... of libm in the library: their last bits differ between machines.
Violations transcendentals(const std::vector<File>& files);
/// Standard headers by which a clock, a locale, a thread, the file system or unkeyed randomness would come in.
Violations environment(const std::vector<File>& files);
Violations quoted_includes(const std::vector<File>& files);
Violations long_files(const std::vector<File>& files, int max_lines);
/// `files` includes the CMakeLists.txt: every source is named by the one of its folder or of a folder above.
Violations unlisted_sources(const std::vector<File>& files);

}  // namespace burin::architecture
