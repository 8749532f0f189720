#include <cstddef>
#include <optional>
#include <utility>

#include <burin/data/svg/paths.hpp>
#include <burin/geom/dash_walk.hpp>

namespace burin::data {

namespace {

constexpr std::size_t max_dashes = 100'000;  // lines beyond are left whole

double length_of(const Subpath& line) {
  double sum = line.closed ? distance(line.points.back(), line.points.front()) : 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i) sum += distance(line.points[i - 1], line.points[i]);
  return sum;
}

/// A line cut into dashes; a closed one that begins and ends in a dash has no gap there.
std::vector<std::vector<Vec2>> dashes_of(const Subpath& line, DashWalk walk) {
  std::vector<std::vector<Vec2>> dashes;
  bool goes_on = false;  // the last dash reaches the point where the next edge begins
  const std::size_t edges = line.points.size() - (line.closed ? 0 : 1);
  for (std::size_t i = 0; i < edges; ++i) {
    const Vec2 from = line.points[i];
    const Vec2 to = line.points[(i + 1) % line.points.size()];
    const double size = distance(from, to);
    bool reaches_end = size == 0.0 && goes_on;
    walk.go(size, [&](double begin, double end) {
      if (begin > 0.0 || !goes_on) dashes.push_back({lerp(from, to, begin / size)});
      dashes.back().push_back(lerp(from, to, end / size));
      reaches_end = end == size;
    });
    goes_on = reaches_end;
  }
  if (line.closed && goes_on && dashes.size() > 1 && dashes.front().front() == line.points.front()) {
    dashes.back().insert(dashes.back().end(), dashes.front().begin() + 1, dashes.front().end());
    dashes.erase(dashes.begin());
  }
  return dashes;
}

void add_area(const SvgShape& shape, std::vector<SvgPath>& paths) {
  SvgPath area{shape.fill->evenodd ? SvgPath::Paint::fill_evenodd : SvgPath::Paint::fill_nonzero, true, {}};
  for (const Subpath& subpath : shape.subpaths) {
    if (subpath.points.size() > 2) area.contours.push_back(subpath.points);
  }
  if (!area.contours.empty()) paths.push_back(std::move(area));
}

void add_strokes(const SvgShape& shape, std::vector<SvgPath>& paths) {
  const std::vector<double>& dashes = shape.stroke->dashes;
  std::optional<DashWalk> walk;
  if (!dashes.empty()) walk.emplace(dashes, shape.stroke->dash_offset);
  const double longest_px =
      walk ? walk->period() * static_cast<double>(max_dashes) / static_cast<double>(dashes.size()) : 0.0;
  for (const Subpath& subpath : shape.subpaths) {
    if (subpath.points.size() > 1 && walk && length_of(subpath) < longest_px && paths.size() < max_dashes) {
      for (std::vector<Vec2>& dash : dashes_of(subpath, *walk)) {
        paths.push_back({SvgPath::Paint::stroke, false, {std::move(dash)}});
      }
    } else {
      paths.push_back({SvgPath::Paint::stroke, subpath.closed && subpath.points.size() > 1, {subpath.points}});
    }
  }
}

void add_outlines(const SvgShape& shape, std::vector<SvgPath>& paths) {
  SvgPath closed{SvgPath::Paint::stroke, true, {}};
  for (const Subpath& subpath : shape.subpaths) {
    const bool is_area = subpath.closed || (shape.fill && !shape.stroke);
    if (is_area && subpath.points.size() > 1) {
      closed.contours.push_back(subpath.points);
    } else {
      paths.push_back({SvgPath::Paint::stroke, false, {subpath.points}});
    }
  }
  if (!closed.contours.empty()) paths.push_back(std::move(closed));
}

}  // namespace

std::vector<SvgPath> svg_paths(const SvgDrawing& drawing, SvgParts parts) {
  std::vector<SvgPath> paths;
  for (const SvgShape& shape : drawing.shapes) {
    if (parts == SvgParts::outlines) {
      add_outlines(shape, paths);
      continue;
    }
    if (shape.fill && parts != SvgParts::strokes) add_area(shape, paths);
    if (shape.stroke && parts != SvgParts::fills) add_strokes(shape, paths);
  }
  return paths;
}

}  // namespace burin::data
