#pragma once

#include <string>
#include <string_view>

namespace burin::output {

/// `text` as every format can carry it: what is not UTF-8, and control characters other than tab, line feed and
/// carriage return, become U+FFFD. Text without these (every TOML file) comes back unchanged.
std::string carried_text(std::string_view text);

}  // namespace burin::output
