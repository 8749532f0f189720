#pragma once

#include <string>
#include <vector>

#include <burin/curves/base_shape.hpp>
#include <burin/geom/vec3.hpp>

namespace burin::curves {

/// What a scheme refines, in the plane or in space.
struct SpaceBase {
  BaseShape plane = square_base();     ///< drawn in the plane z = 0 where there is a camera
  std::vector<SpacePolyline> space{};  ///< instead, when the base was given in space
  std::string text{};                  ///< as it was written, of a base in space

  bool is_in_space() const { return !space.empty(); }
  /// The polylines in space, whatever they were given in.
  std::vector<SpacePolyline> lifted() const;
};

/// "tetrahedron": a base in space by default.
SpaceBase tetrahedron_base();

/// The keys of a base in space written as a table, for help and docs.
std::vector<params::FieldInfo> space_base_fields();

}  // namespace burin::curves

/// All that a BaseShape is, and { points = [[x, y, z], ...] }, { solid = "cube" } (every face a polygon, seen from
/// outside counter-clockwise, circumradius 1), { knot = [2, 3], n = 24 } (corners on a torus about the z axis).
template <>
struct burin::params::ValueType<burin::curves::SpaceBase> {
  static std::string name() { return "base"; }
  static bool read(const Value& value, burin::curves::SpaceBase& base, ReadContext& context);
  static std::string text(const burin::curves::SpaceBase& base) {
    return base.is_in_space() ? base.text : base.plane.text;
  }
};
