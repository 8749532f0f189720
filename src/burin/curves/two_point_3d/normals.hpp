#pragma once

#include <burin/curves/two_point_3d/two_point_3d.hpp>
#include <burin/geom/vec3.hpp>

namespace burin::curves::two_point_3d {

/// Unit vectors across an edge, in the planes that it spans with its left and with its right neighbour. Where one of
/// them is missing or straight on, both are the other's; without both, both are unit(d x up). Zero for an edge without
/// length.
struct Normals {
  Vec3 left;
  Vec3 right;
};

/// The edge from a to b; null: the polyline ends there. Source: reference curves B.
Normals normals_of(const Vec3* before, Vec3 a, Vec3 b, const Vec3* after, Orient orient, Vec3 up);

/// (1 - theta) left + theta right, at length 1 if wanted. Opposite normals that cancel leave the nearer one.
Vec3 blend(const Normals& normals, double theta, bool normalize);

}  // namespace burin::curves::two_point_3d
