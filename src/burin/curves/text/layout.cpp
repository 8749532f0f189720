#include <algorithm>
#include <optional>
#include <utility>

#include <burin/base/math.hpp>
#include <burin/base/utf8.hpp>
#include <burin/curves/text/layout.hpp>

namespace burin::curves::lettering {

namespace {

/// Stands for what has no glyph.
Glyph hollow_box() {
  return {16.0, {{{3.0, 0.0}, {13.0, 0.0}, {13.0, units_per_cap}, {3.0, units_per_cap}, {3.0, 0.0}}}};
}

/// Outside Unicode: the key of the hollow box.
constexpr char32_t no_character = 0x110000;

/// Takes the next character off the text; bytes that are none count one by one.
char32_t take_character(std::string_view& text) {
  const auto [code, length] = first_utf8_character(text);
  text.remove_prefix(std::max<std::size_t>(length, 1));
  return length == 0 ? no_character : code;
}

double share_before_origin(TextAlign align) {
  switch (align) {
    case TextAlign::left:
      return 0.0;
    case TextAlign::center:
      return 0.5;
    case TextAlign::right:
      return 1.0;
  }
  return 0.0;
}

}  // namespace

Layout::Layout(const TextParams& params, Vec2 origin) : shear_(math::tan_degrees(params.slant)) {
  const auto glyph = [&](char32_t character) -> const Glyph& {
    const auto found = glyphs_.find(character);
    if (found != glyphs_.end()) return found->second;
    return glyphs_.emplace(character, glyph_of(params.font, character).value_or(hollow_box())).first->second;
  };
  std::size_t line_begin = 0;
  Vec2 pen;
  const auto end_line = [&] {
    const bool any = letters_.size() > line_begin;
    const double line_width = any ? pen.x - params.tracking : 0.0;
    for (std::size_t i = line_begin; i < letters_.size(); ++i) {
      letters_[i].at.x -= share_before_origin(params.align) * line_width;
    }
    width_ = std::max(width_, line_width);
    line_begin = letters_.size();
    pen = {0.0, pen.y - params.line_height};
  };
  std::string_view text = params.text.text;
  while (!text.empty()) {
    const char32_t character = take_character(text);
    if (character == U'\n') {
      end_line();
      continue;
    }
    const Glyph& letter = glyph(character);
    letters_.push_back({&letter, pen});
    pen.x += letter.advance / units_per_cap + params.tracking;
  }
  end_line();
  for (Letter& letter : letters_) letter.at = letter.at - origin;
}

}  // namespace burin::curves::lettering
