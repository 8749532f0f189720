#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <burin/curves/family.hpp>
#include <burin/curves/space_base.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/params/camera_params.hpp>

namespace burin::curves {

namespace two_point_3d {

/// To which side of an edge beta goes, in the planes that its neighbours span with it.
enum class Orient : std::uint8_t {
  outward,   ///< away from the neighbour
  reference  ///< to the side of d x up: in the plane z = 0 to the right of travel, as in two-point
};

constexpr auto words(Orient) {
  return std::array<params::Word<Orient>, 2>{{{"outward", Orient::outward}, {"reference", Orient::reference}}};
}

/// theta of the markers: one for all, or one for each.
struct Thetas {
  std::vector<two_point::Amount> by_marker{two_point::Amount{0.5, 0.5}};

  /// `marker` from 1.
  const two_point::Amount& of(std::size_t marker) const {
    return by_marker.size() == 1 ? by_marker.front() : by_marker[marker - 1];
  }
};

}  // namespace two_point_3d

/// The two-point scheme in space: Q_ij = P_{i-1} + alpha_j d + s beta_j |d| e_ij, where e_ij is a blend of the edge's
/// normals in the planes of its left and of its right neighbour. Source: Ding & Qi, section 3, space form; reference
/// curves B.
struct TwoPoint3dParams {
  SpaceBase base = tetrahedron_base();
  two_point::Motif motif = two_point::motif_from(two_point::named_motifs().front());
  two_point_3d::Thetas theta;
  std::optional<two_point::SignRule> sign;
  two_point_3d::Orient orient = two_point_3d::Orient::outward;
  bool normalize = true;
  Vec3 up{0.0, 0.0, 1.0};
  int levels = 3;
  params::CameraParams camera;

  static constexpr auto fields() {
    using P = TwoPoint3dParams;
    using params::field;
    return std::tuple{
        field("base", &P::base,
              "what is refined: { points = [[x, y, z], ...], closed = true }, { solid = \"cube\" }, { knot = [2, 3] }, "
              "or "
              "in the plane z = 0 as in two-point"),
        field("motif", &P::motif, "a name of 'burin list motifs' or of [define], or a table, as in two-point"),
        field("theta", &P::theta,
              "0: beta lies in the plane of the left neighbour, 1: of the right one; one for all markers or one for "
              "each, "
              "numbers or expressions in level, edge, marker, rand"),
        field("sign", &P::sign, "sign of beta over the whole sequence; unset: the motif's own flags or sign"),
        field("orient", &P::orient,
              "outward: beta goes away from the neighbours; reference: to the side of edge x `up`, in the plane as in "
              "two-point"),
        field("normalize", &P::normalize, "whether blended normals have length 1; else those between are shorter"),
        field("up", &P::up, "of `reference`, and of edges that no neighbour bends from"),
        field("levels", &P::levels, {0, 1000}, "refinement levels; what is drawn is limited by the view"),
        field("camera", &P::camera, "how it is seen")};
  }
};

/// The family's row in the catalogue.
Family two_point_3d_family();

}  // namespace burin::curves

/// An amount or a list of them.
template <>
struct burin::params::ValueType<burin::curves::two_point_3d::Thetas> {
  static std::string name() { return "amount or list of them"; }
  static bool read(const Value& value, burin::curves::two_point_3d::Thetas& thetas, ReadContext& context);
  static std::string text(const burin::curves::two_point_3d::Thetas& thetas);
};
