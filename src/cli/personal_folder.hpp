#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace burin::cli {

/// Where the user keeps things of a kind, such as "presets": $XDG_DATA_HOME/burin/KIND, else
/// $HOME/.local/share/burin/KIND; nothing without either variable. The folder need not exist.
std::optional<std::string> personal_folder(std::string_view kind);

}  // namespace burin::cli
