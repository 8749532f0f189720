#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <burin/geom/affine2.hpp>
#include <burin/geom/box2.hpp>

/// The symmetry groups of the plane by name: rosettes c1, c2 ..., d1, d2 ...; friezes and wallpapers by their short
/// international names. All maps are isometries, y up.
namespace burin::preset {

/// The copies of a rosette about the origin: c6 six rotations, d6 those and their mirror images. Nothing for other
/// names.
std::optional<std::vector<Affine2>> rosette(std::string_view name);

/// A frieze or wallpaper on a rectangle about the origin.
struct Tiling {
  Box2 domain;                  ///< where one drawing is to be fitted
  std::vector<Affine2> copies;  ///< of that drawing
};

/// More cells than this are not laid out.
inline constexpr double most_cells = 100'000.0;

/// As many whole cells of side `cell_mm` as fit into width x height, centred; friezes repeat from left to right and are
/// as high as the rectangle. Nothing for other names; no copies when not one cell fits. Pre: at most `most_cells` fit.
std::optional<Tiling> tile(std::string_view name, double width_mm, double height_mm, double cell_mm);

/// Whether rosette or tile knows the name.
bool is_symmetry(std::string_view name);
/// The friezes and wallpapers, for suggestions.
std::vector<std::string_view> tiling_names();

}  // namespace burin::preset
