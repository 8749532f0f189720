#pragma once

#include <any>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

namespace burin::testing {

/// One stroke of line art.
struct DrawnLine {
  std::vector<Vec2> points;
  std::uint16_t level = 0;
  friend bool operator==(const DrawnLine&, const DrawnLine&) = default;
};

inline std::any line_art_params(std::string_view family, std::string_view json) {
  const ReadParams read = read_params(family, json);
  EXPECT_TRUE(read.params.has_value()) << json << '\n' << problems_text(read.problems);
  return read.params.value_or(std::any());
}

/// The strokes that a family draws; call order and finiteness are checked on the way.
inline std::vector<DrawnLine> drawn_lines(std::string_view family, std::string_view json,
                                          const DrawContext& context = {}) {
  const Recording recording = record(family, line_art_params(family, json), context);
  std::vector<DrawnLine> lines;
  for (const Recording::Path& path : recording.paths()) {
    const auto points = recording.points(recording.contours(path).front());
    lines.push_back({{points.begin(), points.end()}, path.head.level});
  }
  return lines;
}

inline double length_of(const std::vector<Vec2>& points) {
  double total = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) total += distance(points[i - 1], points[i]);
  return total;
}

}  // namespace burin::testing
