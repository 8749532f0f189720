#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <burin/data/svg/paths.hpp>

namespace burin::data {

namespace {

constexpr std::size_t max_dashes = 100'000;  // lines beyond are left whole

/// A line cut by a pattern of dashes. Source: SVG 1.1, 11.4.
class DashCutter {
 public:
  explicit DashCutter(const SvgStroke& stroke) : dashes_(stroke.dashes) {
    double total = 0.0;
    for (const double dash : dashes_) total += dash;
    double into = std::fmod(stroke.dash_offset, total);
    if (into < 0.0) into += total;
    while (into >= dashes_[at_]) {
      into -= dashes_[at_];
      next();
    }
    left_ = dashes_[at_] - into;
  }

  std::vector<std::vector<Vec2>> cut(const Subpath& line) {
    if (on_) pieces_.push_back({line.points.front()});
    const std::size_t edges = line.points.size() - (line.closed ? 0 : 1);
    for (std::size_t i = 0; i < edges; ++i) {
      edge(line.points[i], line.points[(i + 1) % line.points.size()]);
    }
    return std::move(pieces_);
  }

 private:
  void next() {
    at_ = (at_ + 1) % dashes_.size();
    on_ = !on_;
    left_ = dashes_[at_];
  }

  void edge(Vec2 from, Vec2 to) {
    const double size = distance(from, to);
    double done = 0.0;
    while (size - done > left_ && pieces_.size() < max_dashes) {
      done += left_;
      const Vec2 here = lerp(from, to, done / size);
      if (on_) pieces_.back().push_back(here);
      next();
      if (on_) pieces_.push_back({here});
    }
    left_ -= size - done;
    if (on_) pieces_.back().push_back(to);
  }

  const std::vector<double>& dashes_;
  std::vector<std::vector<Vec2>> pieces_;
  std::size_t at_ = 0;
  bool on_ = true;
  double left_ = 0.0;
};

void add_area(const SvgShape& shape, std::vector<SvgPath>& paths) {
  SvgPath area{shape.fill->evenodd ? SvgPath::Paint::fill_evenodd : SvgPath::Paint::fill_nonzero, true, {}};
  for (const Subpath& subpath : shape.subpaths) {
    if (subpath.points.size() > 2) area.contours.push_back(subpath.points);
  }
  if (!area.contours.empty()) paths.push_back(std::move(area));
}

void add_strokes(const SvgShape& shape, std::vector<SvgPath>& paths) {
  for (const Subpath& subpath : shape.subpaths) {
    if (shape.stroke->dashes.empty() || paths.size() > max_dashes) {
      paths.push_back({SvgPath::Paint::stroke, subpath.closed && subpath.points.size() > 1, {subpath.points}});
      continue;
    }
    for (std::vector<Vec2>& dash : DashCutter(*shape.stroke).cut(subpath)) {
      paths.push_back({SvgPath::Paint::stroke, false, {std::move(dash)}});
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
