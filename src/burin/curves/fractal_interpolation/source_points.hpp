#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/geom/vec2.hpp>

namespace burin::curves::fractal_interpolation {

/// Points to interpolate, with what messages about them need.
struct SourcePoints {
  std::vector<Vec2> points;
  Where origin;            ///< of all of them: the file, or the key of the preset
  std::vector<int> lines;  ///< of the file, one for each point; empty: they stand in the preset

  Where where(std::size_t point) const;
};

/// The points of a CSV file.
Result<SourcePoints> points_of_csv(std::string_view text, const std::string& file);

/// Points that stood at the place of the one before them.
struct Repetitions {
  std::size_t count = 0;
  Where first;  ///< of the first one dropped
};
Repetitions drop_repeated(SourcePoints& source);

/// "d.csv:4: warning: 2 points are dropped that repeat the point before". Pre: there are some.
std::string warning_of(const Repetitions& repetitions);

/// Appends the first point if the last one is another.
void close_up(SourcePoints& source);

/// The first point whose x is not beyond that of its predecessor, as a problem; nothing else is wrong when x increases.
Result<Done> check_increasing(const SourcePoints& source);

}  // namespace burin::curves::fractal_interpolation
