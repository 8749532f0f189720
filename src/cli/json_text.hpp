#pragma once

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>

namespace burin::cli {

/// "text" as a JSON string. Pre: UTF-8.
inline std::string json_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

/// A JSON object, written key by key.
class JsonObject {
 public:
  /// `json` is a finished value.
  void add_json(std::string_view key, std::string_view json) {
    text_ += fmt::format("{}{}: {}", text_.empty() ? "" : ", ", json_string(key), json);
  }
  void add(std::string_view key, std::string_view text) { add_json(key, json_string(text)); }
  void add(std::string_view key, const char* text) { add(key, std::string_view(text)); }
  /// JSON has no infinity and no NaN: they become null.
  void add(std::string_view key, double number) {
    add_json(key, std::isfinite(number) ? shortest_text(number) : "null");
  }
  void add(std::string_view key, bool value) { add_json(key, value ? "true" : "false"); }
  void add(std::string_view key, std::integral auto count) { add_json(key, fmt::format("{}", count)); }

  std::string text() const { return '{' + text_ + '}'; }

 private:
  std::string text_;
};

}  // namespace burin::cli
