#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <burin/output/pdf/writer.hpp>

#include "support/pdf_reader.hpp"
#include "support/svg_drawing.hpp"

namespace burin::test {

struct PdfText {
  std::string bytes;
  std::uint64_t skipped = 0;

  PdfFile file() const { return PdfFile(bytes); }
  std::vector<PdfPainted> painted() const { return test::painted(file()); }
};

/// The PDF of `paths`; throws when the writer reports a problem.
inline PdfText pdf_of(const Sheet& sheet, const std::vector<DrawnPath>& paths, const OutputOptions& options = {},
                      std::size_t span = SIZE_MAX) {
  StringSink bytes;
  const auto sink = output::open_pdf(bytes, sheet, options);
  (void)draw(paths, *sink, span);
  const Result<Done> done = sink->finish();
  if (!done) throw std::runtime_error(problems_text(done.problems()));
  return {bytes.take(), sink->skipped_points()};
}

inline DrawnPath stroke(std::vector<Vec2> points, bool closed = false, LayerId layer = 0) {
  DrawnPath path;
  path.head.layer = layer;
  path.head.closed = closed;
  path.contours = {std::move(points)};
  return path;
}

inline DrawnPath fill(std::vector<std::vector<Vec2>> contours, Paint rule = Paint::fill_nonzero) {
  DrawnPath path;
  path.head.paint = rule;
  path.head.closed = true;
  path.contours = std::move(contours);
  return path;
}

/// A stroke with a segment between each of its points.
inline std::vector<Vec2> zigzag(std::size_t points) {
  std::vector<Vec2> zigzag;
  for (std::size_t i = 0; i < points; ++i) {
    zigzag.push_back({0.001 * static_cast<double>(i), i % 2 == 0 ? 0.0 : 0.5});
  }
  return zigzag;
}

/// Every contour that is painted, in order.
inline std::vector<PdfContour> contours_of(const std::vector<PdfPainted>& painted) {
  std::vector<PdfContour> all;
  for (const PdfPainted& piece : painted) all.insert(all.end(), piece.contours.begin(), piece.contours.end());
  return all;
}

/// Whole steps of 10^-decimals mm.
inline std::pair<long long, long long> steps(Vec2 p, int decimals = 3) {
  const double scale = std::pow(10.0, decimals);
  return {std::llround(p.x * scale), std::llround(p.y * scale)};
}

}  // namespace burin::test
