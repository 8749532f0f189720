#pragma once

#include <span>
#include <vector>

#include <burin/geom/vec2.hpp>
#include <burin/path/sheet.hpp>

/// What areas have in common, and what is left of one under others. The only room for Clipper.
namespace burin::passes {

/// Closed contours in millimetres, and which points they enclose.
struct Area {
  std::vector<std::vector<Vec2>> contours;
  Paint rule = Paint::fill_nonzero;
};

/// `area` without what any of `others` covers, its holes as contours of their own: both rules read it alike. New
/// corners are exact to 1e-6 mm, and so is every other one; coordinates beyond 1e9 mm are moved there. Time: as Vatti's
/// algorithm, O(n log n) for n edges and crossings.
std::vector<std::vector<Vec2>> difference(const Area& area, std::span<const Area> others);

/// What `area` shares with the union of `others`; the same terms.
std::vector<std::vector<Vec2>> common(const Area& area, std::span<const Area> others);

}  // namespace burin::passes
