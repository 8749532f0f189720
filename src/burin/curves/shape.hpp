#pragma once

#include <array>
#include <string>

#include <burin/curves/base_shape.hpp>
#include <burin/curves/family.hpp>

namespace burin::curves {

enum class ShapeKind : std::uint8_t { rectangle, disc, ring, polygon, star, path };
constexpr auto words(ShapeKind) {
  return std::array<params::Word<ShapeKind>, 6>{{{"rectangle", ShapeKind::rectangle},
                                                 {"disc", ShapeKind::disc},
                                                 {"ring", ShapeKind::ring},
                                                 {"polygon", ShapeKind::polygon},
                                                 {"star", ShapeKind::star},
                                                 {"path", ShapeKind::path}}};
}

/// A closed shape about the origin, or a path. Model units, y up.
struct ShapeParams {
  ShapeKind kind = ShapeKind::disc;
  double r = 1.0;
  double inner = 0.382;
  double width = 1.0;
  double height = 1.0;
  double corner = 0.0;
  int n = 5;
  double turn = 0.0;
  std::string d;

  static constexpr auto fields() {
    return std::tuple{
        params::field("kind", &ShapeParams::kind, "what it is"),
        params::field("r", &ShapeParams::r, params::positive, "radius of a disc, ring, polygon or star"),
        params::field("inner", &ShapeParams::inner, {0.0, 1.0, true, true},
                      "radius of a ring's hole or of a star's inner corners, in shares of r"),
        params::field("width", &ShapeParams::width, params::positive, "of a rectangle"),
        params::field("height", &ShapeParams::height, params::positive, "of a rectangle"),
        params::field("corner", &ShapeParams::corner, params::not_negative,
                      "radius of a rectangle's corners, at most half its shorter side"),
        params::field("n", &ShapeParams::n, {3, 10000}, "corners of a polygon, points of a star; the first is up"),
        params::field("turn", &ShapeParams::turn, {-3600.0, 3600.0},
                      "turn about the origin in degrees, counter-clockwise"),
        params::field("d", &ShapeParams::d, "SVG path data of a path, y down as in SVG")};
  }
};

/// The family's row in the catalogue.
Family shape_family();

}  // namespace burin::curves
