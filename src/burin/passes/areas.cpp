#include <algorithm>
#include <clipper.hpp>
#include <cmath>

#include <burin/passes/areas.hpp>

namespace burin::passes {

namespace {

using ClipperLib::Paths;

/// Clipper counts in integers; up to a page of a metre it needs no more than 64 bits for a product.
constexpr double units_per_mm = 1e6;
constexpr double farthest_mm = 1e9;

ClipperLib::cInt in_units(double mm) {
  return std::llround(std::clamp(mm, -farthest_mm, farthest_mm) * units_per_mm);
}

Paths in_units(const std::vector<std::vector<Vec2>>& contours) {
  Paths paths;
  for (const std::vector<Vec2>& contour : contours) {
    ClipperLib::Path& path = paths.emplace_back();
    for (const Vec2 p : contour) path.emplace_back(in_units(p.x), in_units(p.y));
  }
  return paths;
}

ClipperLib::PolyFillType fill_type(Paint rule) {
  return rule == Paint::fill_evenodd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero;
}

std::vector<std::vector<Vec2>> combined(ClipperLib::ClipType how, const Area& area, std::span<const Area> others) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(in_units(area.contours), ClipperLib::ptSubject, true);
  for (const Area& other : others) {
    // Each by its own rule first: then all turn the same way, and none can undo another.
    Paths simple;
    ClipperLib::SimplifyPolygons(in_units(other.contours), simple, fill_type(other.rule));
    clipper.AddPaths(simple, ClipperLib::ptClip, true);
  }
  Paths result;
  clipper.Execute(how, result, fill_type(area.rule), ClipperLib::pftNonZero);
  std::vector<std::vector<Vec2>> contours;
  for (const ClipperLib::Path& path : result) {
    std::vector<Vec2>& contour = contours.emplace_back();
    for (const ClipperLib::IntPoint& p : path) {
      contour.push_back({static_cast<double>(p.X) / units_per_mm, static_cast<double>(p.Y) / units_per_mm});
    }
  }
  return contours;
}

}  // namespace

std::vector<std::vector<Vec2>> difference(const Area& area, std::span<const Area> others) {
  return combined(ClipperLib::ctDifference, area, others);
}

std::vector<std::vector<Vec2>> common(const Area& area, std::span<const Area> others) {
  return combined(ClipperLib::ctIntersection, area, others);
}

}  // namespace burin::passes
