#pragma once

#include <vector>

#include <burin/curves/refinement/cover.hpp>
#include <burin/curves/two_point_3d/two_point_3d.hpp>
#include <burin/geom/vec3.hpp>

namespace burin::curves::two_point_3d {

/// How far an edge's refinement reaches, whatever normals, signs and draws there are. The proof is that of reference
/// curves A.4, with balls for discs and level by level: it needs of the normals only that they are unit vectors across
/// the edge.
class SpaceReach {
 public:
  explicit SpaceReach(const TwoPoint3dParams& params);

  /// Of the edge ab with so many levels to come, the next of which has this decay.
  Cover<Vec3> cover(Vec3 a, Vec3 b, int remaining, double decay) const;
  /// False: nothing is known of how far an edge reaches.
  bool is_finite() const;

 private:
  bool absolute_;
  /// By levels to come: of an edge of length 1, from its midpoint; absolute: from the edge, for decay 1.
  std::vector<double> reach_;
};

}  // namespace burin::curves::two_point_3d
