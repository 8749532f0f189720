#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <burin/base/result.hpp>
#include <burin/params/read_value.hpp>

namespace burin::curves::lettering {

/// What a text says: UTF-8, lines parted by \n.
struct Caption {
  std::string text;
};

/// The first character that cannot be drawn, in words: "no glyph for 'ж' (U+0436), character 3 of line 1"; nothing when
/// all can.
std::optional<std::string> undrawable(std::string_view text);

}  // namespace burin::curves::lettering

/// Line ends become \n, {name} what the context's placeholders say, {{ and }} braces. Text put in is not searched
/// again.
template <>
struct burin::params::ValueType<burin::curves::lettering::Caption> {
  static std::string name() { return "text"; }
  static bool read(const Value& value, burin::curves::lettering::Caption& caption, ReadContext& context);
  static std::string text(const burin::curves::lettering::Caption& caption) {
    return ValueType<std::string>::text(caption.text);
  }
};
