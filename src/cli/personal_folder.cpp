#include <cstdlib>

#include <fmt/format.h>

#include <cli/personal_folder.hpp>

namespace burin::cli {

std::optional<std::string> personal_folder(std::string_view kind) {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && *data != '\0') return fmt::format("{}/burin/{}", data, kind);
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home != '\0') return fmt::format("{}/.local/share/burin/{}", home, kind);
  return std::nullopt;
}

}  // namespace burin::cli
