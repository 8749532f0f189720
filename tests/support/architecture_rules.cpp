#include "support/architecture_rules.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace burin::architecture {
namespace {

constexpr std::string_view library_root = "src/burin/";

bool is_source(std::string_view path) {
  return path.ends_with(".cpp") || path.ends_with(".hpp");
}
bool in_library(std::string_view path) {
  return path.starts_with(library_root) && is_source(path);
}
bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

struct Include {
  int line = 0;
  bool quoted = false;
  std::string header;
};

std::vector<Include> includes_of(const File& file) {
  std::vector<Include> found;
  std::istringstream lines(file.text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const std::size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const std::size_t open = line.find_first_of("<\"", word);
    if (open == std::string::npos) continue;
    const std::size_t close = line.find_first_of(">\"", open + 1);
    found.push_back({number, line[open] == '"', line.substr(open + 1, close - open - 1)});
  }
  return found;
}

std::string place(const File& file, int line) {
  return file.path + ":" + std::to_string(line) + ": ";
}

/// The room an included header belongs to; empty for headers of nobody here.
std::string room_of_header(std::string_view header) {
  return room_of("src/" + std::string(header));
}

const Room* find_room(const std::vector<Room>& rooms, std::string_view name) {
  const auto found = std::find_if(rooms.begin(), rooms.end(), [&](const Room& r) { return r.name == name; });
  return found == rooms.end() ? nullptr : &*found;
}

bool may_reach(const std::vector<Room>& rooms, std::string_view from, std::string_view to) {
  if (from == to) return true;
  const Room* room = find_room(rooms, from);
  return room != nullptr && std::any_of(room->may_use.begin(), room->may_use.end(),
                                        [&](std::string_view next) { return may_reach(rooms, next, to); });
}

int line_at(std::string_view text, std::size_t offset) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

/// Whether `name` stands in `text` with no letter of a longer name or path around it.
bool names(std::string_view text, std::string_view name) {
  const auto part_of_name = [](char c) { return is_word(c) || c == '.' || c == '/' || c == '-'; };
  for (std::size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !part_of_name(text[at - 1])) && (end == text.size() || !part_of_name(text[end]))) return true;
  }
  return false;
}

using Lists = std::map<std::string, std::string>;

/// The text of each CMakeLists.txt by its folder.
Lists lists_of(const std::vector<File>& files) {
  Lists lists;
  for (const File& file : files) {
    constexpr std::string_view name = "/CMakeLists.txt";
    if (file.path.ends_with(name)) lists[file.path.substr(0, file.path.size() - name.size())] = file.text;
  }
  return lists;
}

/// Whether test(list, name of the file from there) holds for the list of the file's folder or of one above.
template <class Test>
bool any_list(const Lists& lists, const std::string& path, const Test& test) {
  for (std::size_t slash = path.rfind('/'); slash != std::string::npos && slash > 0;
       slash = path.rfind('/', slash - 1)) {
    const auto list = lists.find(path.substr(0, slash));
    if (list != lists.end() && test(std::string_view(list->second), std::string_view(path).substr(slash + 1))) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::string code_only(std::string_view text) {
  std::string code(text);
  const auto blank = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, code.size()); ++i) {
      if (code[i] != '\n') code[i] = ' ';
    }
  };
  const auto after = [&](std::string_view what, std::size_t from) {
    const std::size_t at = text.find(what, from);
    return at == std::string_view::npos ? text.size() : at + what.size();
  };
  std::size_t i = 0;
  while (i < text.size()) {
    const std::string_view rest = text.substr(i);
    std::size_t end = i + 1;
    if (rest.starts_with("//")) {
      end = std::min(text.find('\n', i), text.size());
      blank(i, end);
    } else if (rest.starts_with("/*")) {
      end = after("*/", i + 2);
      blank(i, end);
    } else if (rest.starts_with("R\"") && (i == 0 || !is_word(text[i - 1]))) {
      const std::size_t open = std::min(text.find('(', i), text.size());
      end = after(")" + std::string(text.substr(i + 2, open - i - 2)) + "\"", open);
      blank(i, end);
    } else if (rest.front() == '"' || (rest.front() == '\'' && (i == 0 || !is_word(text[i - 1])))) {
      while (end < text.size() && text[end] != rest.front() && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
      ++end;
      blank(i, end);
    }
    i = end;
  }
  return code;
}

std::string room_of(std::string_view path) {
  constexpr std::string_view root = "src/";
  if (!path.starts_with(root)) return {};
  if (!path.starts_with(library_root)) return path.starts_with("src/cli/") ? "cli" : "";
  const std::string_view inside = path.substr(library_root.size());
  const std::size_t slash = inside.find('/');
  return slash == std::string_view::npos ? "burin" : std::string(inside.substr(0, slash));
}

Violations edges(const std::vector<File>& files, const std::vector<Room>& rooms) {
  Violations found;
  for (const File& file : files) {
    const std::string from = room_of(file.path);
    if (from.empty() || !is_source(file.path)) continue;
    for (const Include& include : includes_of(file)) {
      const std::string to = room_of_header(include.header);
      if (to.empty() || may_reach(rooms, from, to)) continue;
      found.push_back(place(file, include.line) + "room " + from + " may not use " + to + " (" + include.header + ")");
    }
  }
  return found;
}

Violations map_of_rooms(std::string_view readme, const std::vector<std::string>& folders,
                        const std::vector<Room>& rooms) {
  std::map<std::string, bool> rows;  // name, whether it is coming
  std::istringstream lines{std::string(readme)};
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string cell = line.substr(2, line.find('|', 2) - 2);
    rows[cell.substr(1, cell.find('`', 1) - 1)] = cell.find("(coming)") != std::string::npos;
  }
  Violations found;
  for (const std::string& folder : folders) {
    if (!rows.contains(folder)) found.push_back("src/README.md: does not name the room " + folder);
    if (find_room(rooms, folder) == nullptr) found.push_back("src/" + folder + ": not in the architecture's table");
  }
  for (const auto& [name, coming] : rows) {
    const bool exists = std::find(folders.begin(), folders.end(), name) != folders.end();
    if (!exists && !coming) found.push_back("src/README.md: the room " + name + " has no folder");
    if (exists && coming) found.push_back("src/README.md: the room " + name + " is there and no longer coming");
    if (find_room(rooms, name) == nullptr) found.push_back("src/README.md: the room " + name + " is in no table");
  }
  return found;
}

Violations libraries(const std::vector<File>& files, const std::vector<Library>& libraries) {
  Violations found;
  std::map<std::pair<std::string_view, std::string_view>, std::set<std::string>> users;
  for (const File& file : files) {
    if (!is_source(file.path)) continue;
    for (const Include& include : includes_of(file)) {
      for (const Library& library : libraries) {
        if (!std::string_view(include.header).starts_with(library.header)) continue;
        const auto home = std::find_if(library.homes.begin(), library.homes.end(), [&](std::string_view prefix) {
          return std::string_view(file.path).starts_with(prefix);
        });
        if (home == library.homes.end()) {
          std::string all;
          for (const std::string_view prefix : library.homes) all += " " + std::string(prefix);
          found.push_back(place(file, include.line) + include.header + " may be named only in" + all);
        } else if (library.one_file) {
          users[{library.header, *home}].insert(file.path);
        }
      }
    }
  }
  for (const auto& [library, by] : users) {
    if (by.size() <= 1) continue;
    std::string all;
    for (const std::string& path : by) all += " " + path;
    found.push_back(std::string(library.first) + ": named in more than one file:" + all);
  }
  return found;
}

Violations public_headers(const std::vector<File>& files) {
  const Lists lists = lists_of(files);
  Violations found;
  for (const File& file : files) {
    if (!in_library(file.path) || !file.path.ends_with(".hpp")) continue;
    const bool installed = any_list(lists, file.path, [](std::string_view list, std::string_view name) {
      return names(list.substr(std::min(list.find("FILE_SET"), list.size())), name);
    });
    if (!installed) continue;
    for (const Include& include : includes_of(file)) {
      const bool ours = include.header.starts_with("burin/");
      const bool standard = include.header.find_first_of("./") == std::string::npos;
      if (!ours && !standard) {
        found.push_back(place(file, include.line) + "a public header must not need " + include.header);
      }
    }
  }
  return found;
}

Violations transcendentals(const std::vector<File>& files) {
  static const std::set<std::string_view> forbidden{
      "sin",   "cos",   "tan",  "asin",   "acos",  "atan", "atan2", "sinh",  "cosh",  "tanh",   "asinh",
      "acosh", "atanh", "exp",  "exp2",   "expm1", "log",  "log2",  "log10", "log1p", "pow",    "cbrt",
      "hypot", "erf",   "erfc", "tgamma", "sinf",  "cosf", "expf",  "logf",  "powf",  "sincos", "lgamma"};
  Violations found;
  for (const File& file : files) {
    if (!in_library(file.path)) continue;
    const bool implements = file.path.starts_with("src/burin/base/");
    const std::string code = code_only(file.text);
    for (std::size_t i = 0; i < code.size();) {
      if (!is_word(code[i])) {
        ++i;
        continue;
      }
      std::size_t end = i;
      while (end < code.size() && is_word(code[end])) ++end;
      const std::string_view word = std::string_view(code).substr(i, end - i);
      const std::string_view before = std::string_view(code).substr(0, i);
      const bool from_std =
          before.ends_with("std::") || (before.ends_with("::") && !is_word(before[before.size() - 3]));
      const bool bare = !before.ends_with("::") && !before.ends_with('.') && !before.ends_with("->") && !implements &&
                        end < code.size() && code[end] == '(';
      if (forbidden.contains(word) && (from_std || bare)) {
        found.push_back(place(file, line_at(code, i)) + "libm's " + std::string(word) +
                        " differs between machines; use burin/base/math.hpp");
      }
      i = end;
    }
  }
  return found;
}

Violations environment(const std::vector<File>& files) {
  static const std::set<std::string_view> forbidden{"chrono", "ctime",    "locale",     "clocale", "random",
                                                    "thread", "iostream", "filesystem", "fstream", "time.h"};
  Violations found;
  for (const File& file : files) {
    if (!in_library(file.path)) continue;
    for (const Include& include : includes_of(file)) {
      if (!forbidden.contains(include.header)) continue;
      found.push_back(place(file, include.line) + "the library has no <" + include.header +
                      ">: what it draws depends on its input alone");
    }
  }
  return found;
}

Violations quoted_includes(const std::vector<File>& files) {
  Violations found;
  for (const File& file : files) {
    if (room_of(file.path).empty() || !is_source(file.path)) continue;
    for (const Include& include : includes_of(file)) {
      if (include.quoted) found.push_back(place(file, include.line) + "write #include <...> with the path from src");
    }
  }
  return found;
}

Violations long_files(const std::vector<File>& files, int max_lines) {
  Violations found;
  for (const File& file : files) {
    const auto lines = std::count(file.text.begin(), file.text.end(), '\n');
    if (is_source(file.path) && lines > max_lines) {
      found.push_back(file.path + ": " + std::to_string(lines) + " lines; split it at its nouns");
    }
  }
  return found;
}

Violations unlisted_sources(const std::vector<File>& files) {
  const Lists lists = lists_of(files);
  Violations found;
  for (const File& file : files) {
    if (!is_source(file.path)) continue;
    const bool listed =
        any_list(lists, file.path, [](std::string_view list, std::string_view name) { return names(list, name); });
    if (!listed) found.push_back(file.path + ": in no CMakeLists.txt");
  }
  return found;
}

}  // namespace burin::architecture
