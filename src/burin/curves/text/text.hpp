#pragma once

#include <array>
#include <string>
#include <string_view>

#include <burin/curves/family.hpp>
#include <burin/curves/text/caption.hpp>
#include <burin/curves/text/font.hpp>

namespace burin::curves {

enum class TextAlign : std::uint8_t { left, center, right };
constexpr auto words(TextAlign) {
  return std::array<params::Word<TextAlign>, 3>{
      {{"left", TextAlign::left}, {"center", TextAlign::center}, {"right", TextAlign::right}}};
}

/// Text in the single-stroke letters of the Hershey fonts. Model units: capitals are exactly 1 high, the first line
/// stands on y = 0; x = 0 is where its lines begin, have their middle or end, as `align` says.
struct TextParams {
  lettering::Caption text;
  lettering::Font font = lettering::Font::sans;
  TextAlign align = TextAlign::left;
  double line_height = 1.8;
  double tracking = 0.0;
  double slant = 0.0;

  static constexpr auto fields() {
    return std::tuple{
        params::field("text", &TextParams::text,
                      "what is written, in one line or several; {title}, {author}, {summary}, {seed} and {knob} stand "
                      "for those of the preset, {{ and }} for braces"),
        params::field("font", &TextParams::font, "face of the letters; bold ones double their strokes"),
        params::field("align", &TextParams::align, "how lines of different length stand to each other"),
        params::field("line_height", &TextParams::line_height, {0.0, 100.0},
                      "from one baseline to the next, in heights of capitals"),
        params::field("tracking", &TextParams::tracking, {-1.0, 100.0},
                      "space added after each letter, in heights of capitals"),
        params::field("slant", &TextParams::slant, {-60.0, 60.0}, "lean of the letters to the right in degrees")};
  }
};

/// The family's row in the catalogue.
Family text_family();

/// Draws a label: one open path for each stroke, mapped by `sink_from_model`, under `head`. What has no glyph is drawn
/// as a hollow box. O(points).
[[nodiscard]] Flow draw_text(const TextParams& params, const Affine2& sink_from_model, const PathHead& head,
                             PathSink& sink);

/// The box of what draw_text draws; empty when that is nothing.
Box2 text_box(const TextParams& params, const Affine2& sink_from_model = {});

/// From the beginning of the longest line to its end, with the space that belongs to its letters, in model units.
double text_width(const TextParams& params);

}  // namespace burin::curves
