#pragma once

#include <string>
#include <vector>

#include <burin/output/svg_writer.hpp>

#include "support/random_paths.hpp"
#include "support/svg_reader.hpp"

namespace burin::test {

/// A sheet of `layers` full round strokes in two pens.
inline Sheet plain_sheet(std::size_t layers = 1) {
  Sheet sheet;
  sheet.pens = {{"ink", {}, 0.3}, {"red", {200, 0, 0}, 0.8}};
  for (std::size_t i = 0; i < layers; ++i) {
    SheetLayer layer;
    layer.name = "layer " + std::to_string(i);
    layer.pen = i % 2;
    sheet.layers.push_back(layer);
  }
  return sheet;
}

struct SvgText {
  std::string text;
  std::uint64_t skipped = 0;
};

/// The SVG of `paths`; throws when the writer reports a problem.
inline SvgText svg_of(const Sheet& sheet, const std::vector<DrawnPath>& paths, const OutputOptions& options = {},
                      std::size_t span = SIZE_MAX) {
  StringSink bytes;
  const auto sink = output::open_svg(bytes, sheet, options);
  (void)draw(paths, *sink, span);
  const Result<Done> done = sink->finish();
  if (!done) throw std::runtime_error(problems_text(done.problems()));
  return {bytes.take(), sink->skipped_points()};
}

/// The layers of an SVG, in order.
inline std::vector<const XmlElement*> layers_of(const XmlElement& svg) {
  std::vector<const XmlElement*> layers;
  for (const XmlElement& child : svg.children) {
    if (child.has("inkscape:groupmode")) layers.push_back(&child);
  }
  return layers;
}

inline std::size_t segment_count(const std::vector<ReadContour>& contours) {
  std::size_t count = 0;
  for (const ReadContour& contour : contours) count += contour.points.size() - 1 + (contour.closed ? 1 : 0);
  return count;
}

}  // namespace burin::test
