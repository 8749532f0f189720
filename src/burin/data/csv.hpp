#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/geom/vec2.hpp>

namespace burin::data {

/// Points, and the line that each stands in.
struct CsvPoints {
  std::vector<Vec2> points;
  std::vector<int> lines;  ///< from 1
};

/// Points from comma (or semicolon, tab, blank) separated text: one point a line, first two columns x and y, or the
/// columns called x and y, or lon and lat, when there is a header; lines starting with # and empty lines are passed
/// over. Problems carry `file` and the line. At most 10^7 points.
Result<CsvPoints> read_csv_lines(std::string_view text, const std::string& file);

/// The points alone.
Result<std::vector<Vec2>> read_csv_points(std::string_view text, const std::string& file);

/// The same points as paths: a new one begins where the columns called layer or path change, as burin's own CSV has
/// them; without such columns all points are one.
Result<std::vector<std::vector<Vec2>>> read_csv_paths(std::string_view text, const std::string& file);

}  // namespace burin::data
