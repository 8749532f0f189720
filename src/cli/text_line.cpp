#include <algorithm>

#include <burin/curves/text/text.hpp>
#include <cli/text_line.hpp>

namespace burin::cli {

namespace {

curves::TextParams params_of(const TextLine& line) {
  curves::TextParams params;
  params.text.text = line.text;
  params.align = line.from == TextLine::From::left     ? curves::TextAlign::left
                 : line.from == TextLine::From::middle ? curves::TextAlign::center
                                                       : curves::TextAlign::right;
  return params;
}

/// Millimetres in a height of a capital.
double scale_of(const TextLine& line, const curves::TextParams& params) {
  const double width = curves::text_width(params);
  return width > 0.0 ? std::min(line.height_mm, line.room_mm / width) : line.height_mm;
}

}  // namespace

double width_mm(const TextLine& line) {
  const curves::TextParams params = params_of(line);
  return scale_of(line, params) * curves::text_width(params);
}

Flow draw_line(const TextLine& line, const PathHead& head, PathSink& sink) {
  const curves::TextParams params = params_of(line);
  const double scale = scale_of(line, params);
  return curves::draw_text(params, translation(line.at) * scaling(scale, -scale), head, sink);
}

}  // namespace burin::cli
