#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/fractal_interpolation/source_points.hpp>
#include <burin/data/csv.hpp>

namespace burin::curves::fractal_interpolation {

Where SourcePoints::where(std::size_t point) const {
  return lines.empty() ? origin : Where{origin.file, lines[point], 1};
}

Result<SourcePoints> points_of_csv(std::string_view text, const std::string& file) {
  Result<data::CsvPoints> read = data::read_csv_lines(text, file);
  if (!read) return read.problems();
  return SourcePoints{std::move(read->points), {file}, std::move(read->lines)};
}

Repetitions drop_repeated(SourcePoints& source) {
  Repetitions repetitions;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < source.points.size(); ++i) {
    if (kept > 0 && source.points[i] == source.points[kept - 1]) {
      if (repetitions.count++ == 0) repetitions.first = source.where(i);
      continue;
    }
    source.points[kept] = source.points[i];
    if (!source.lines.empty()) source.lines[kept] = source.lines[i];
    ++kept;
  }
  source.points.resize(kept);
  if (!source.lines.empty()) source.lines.resize(kept);
  return repetitions;
}

std::string warning_of(const Repetitions& repetitions) {
  const Where& where = repetitions.first;
  std::string text = where.line > 0 ? fmt::format("{}:{}", where.file, where.line) : where.file;
  text += text.empty() ? "" : ": ";
  return text + (repetitions.count == 1
                     ? "warning: 1 point is dropped that repeats the point before"
                     : fmt::format("warning: {} points are dropped that repeat the point before", repetitions.count));
}

void close_up(SourcePoints& source) {
  if (source.points.front() == source.points.back()) return;
  source.points.push_back(source.points.front());
  if (!source.lines.empty()) source.lines.push_back(source.lines.front());
}

Result<Done> check_increasing(const SourcePoints& source) {
  for (std::size_t i = 1; i < source.points.size(); ++i) {
    const double x = source.points[i].x;
    const double before = source.points[i - 1].x;
    if (x > before) continue;
    return Problem{source.where(i),
                   fmt::format("x must increase from point to point, but {} follows {} (point {}); sort the points, or "
                               "set over = \"chords\" for a curve that turns back",
                               shortest_text(x), shortest_text(before), i + 1)};
  }
  return Done{};
}

}  // namespace burin::curves::fractal_interpolation
