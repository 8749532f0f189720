#include "sample_reference.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace burin::test {
namespace {

using Real = long double;

struct Vector {
  Real x;
  Real y;
};

Vector between(Point a, Point b) {
  return {static_cast<Real>(b.x) - a.x, static_cast<Real>(b.y) - a.y};
}
Real dot(Vector a, Vector b) {
  return a.x * b.x + a.y * b.y;
}
Real cross(Vector a, Vector b) {
  return a.x * b.y - a.y * b.x;
}
Real length(Vector a) {
  return std::sqrt(dot(a, a));
}

bool in_disc(Point center, Real radius, Point p) {
  const Vector v = between(center, p);
  return dot(v, v) <= radius * radius;
}

bool in_body(Point a, Point b, Real half_width, Point p) {
  const Vector d = between(a, b);
  const Vector v = between(a, p);
  return dot(d, v) >= 0 && dot(d, v) <= dot(d, d) && std::abs(cross(d, v)) <= half_width * length(d);
}

bool in_square_cap(Point inner, Point end, Real half_width, Point p) {
  const Vector d = between(inner, end);
  const Vector v = between(end, p);
  const Real along = dot(d, v) / length(d);
  return along >= 0 && along <= half_width && std::abs(cross(d, v)) <= half_width * length(d);
}

/// Inside a polygon that is convex, whichever way it runs.
bool in_convex(const std::vector<Vector>& corners, Vector p) {
  bool left = true;
  bool right = true;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector a = corners[k];
    const Vector b = corners[(k + 1) % corners.size()];
    const Real side = cross({b.x - a.x, b.y - a.y}, {p.x - a.x, p.y - a.y});
    left = left && side >= 0;
    right = right && side <= 0;
  }
  return left || right;
}

bool in_join(const ReferenceStroke& stroke, Point before, Point corner, Point after, Point p) {
  const Vector in = between(before, corner);
  const Vector out = between(corner, after);
  const Vector v = between(corner, p);
  const Real turn = cross(in, out);
  if (turn == 0 && dot(in, out) > 0) return false;
  if (stroke.join == Join::round) {
    // Nearer to the corner than to either stroke drawn on.
    return dot(in, v) >= 0 && dot(out, v) <= 0 && in_disc(corner, stroke.half_width, p);
  }
  if (turn == 0) return false;
  // The outer corners of both strokes.
  const Real side = turn > 0 ? 1 : -1;
  const Real r = stroke.half_width;
  const Vector one{side * in.y / length(in) * r, -side * in.x / length(in) * r};
  const Vector other{side * out.y / length(out) * r, -side * out.x / length(out) * r};
  std::vector<Vector> corners{{0, 0}, one, other};
  const Real cosine = dot(in, out) / (length(in) * length(out));
  if (stroke.join == Join::miter && 1 / std::sqrt((1 + cosine) / 2) <= stroke.miter_limit) {
    corners.insert(corners.begin() + 2, {(one.x + other.x) / (1 + cosine), (one.y + other.y) / (1 + cosine)});
  }
  return in_convex(corners, v);
}

}  // namespace

ReferenceStroke ReferenceStroke::without_repeats() const {
  ReferenceStroke stroke = *this;
  std::vector<Point>& line = stroke.points;
  line.erase(std::unique(line.begin(), line.end()), line.end());
  if (closed && line.size() > 1 && line.front() == line.back()) line.pop_back();
  return stroke;
}

bool ReferenceStroke::covers(Point p) const {
  const std::vector<Point>& line = points;
  const std::size_t count = line.size();
  if (count == 1) {
    if (cap == Cap::round) return in_disc(line[0], half_width, p);
    if (cap == Cap::butt) return false;
    return std::abs(p.x - line[0].x) <= half_width && std::abs(p.y - line[0].y) <= half_width;
  }
  for (std::size_t k = 0; k < count; ++k) {
    if ((k + 1 < count || closed) && in_body(line[k], line[(k + 1) % count], half_width, p)) return true;
    const bool has_join = closed || (k > 0 && k + 1 < count);
    if (has_join && in_join(*this, line[(k + count - 1) % count], line[k], line[(k + 1) % count], p)) return true;
  }
  if (closed) return false;
  for (const auto& [end, inner] : {std::pair(line[0], line[1]), std::pair(line[count - 1], line[count - 2])}) {
    if (cap == Cap::round && in_disc(end, half_width, p)) return true;
    if (cap == Cap::square && in_square_cap(inner, end, half_width, p)) return true;
  }
  return false;
}

bool ReferenceFill::covers(Point p) const {
  int winding = 0;
  int edges = 0;
  for (const std::vector<Point>& contour : contours) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Point a = contour[k];
      const Point b = contour[(k + 1) % contour.size()];
      const bool down = a.y <= p.y && p.y < b.y;
      const bool up = b.y <= p.y && p.y < a.y;
      const Real side = cross(between(a, b), between(a, p));
      if ((down && side <= 0) || (up && side >= 0)) {
        winding += down ? 1 : -1;
        ++edges;
      }
    }
  }
  return evenodd ? edges % 2 == 1 : winding != 0;
}

Point sample_position(int i, int j, int row, int column) {
  const double x = i + (column + (row + 0.5) / 8.0) / 8.0;
  const double y = j + (row + 1 - (column + 0.5) / 8.0) / 8.0;
  return {static_cast<std::int32_t>(1024.0 * x), static_cast<std::int32_t>(1024.0 * y)};
}

std::vector<Samples> samples_of(Ink& ink, const PixelBox& part) {
  std::vector<Samples> all;
  for (int j = part.top; j < part.bottom; ++j) {
    for (int i = part.left; i < part.right; ++i) all.push_back(*ink.tiles().at(i, j, 0));
  }
  return all;
}

int differing_samples(const std::vector<Samples>& a, const std::vector<Samples>& b) {
  if (a.size() != b.size()) std::abort();
  int differing = 0;
  for (std::size_t k = 0; k < a.size(); ++k) differing += std::popcount(a[k] ^ b[k]);
  return differing;
}

}  // namespace burin::test
