#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <burin/curves/family.hpp>
#include <burin/curves/space_base.hpp>
#include <burin/params/camera_params.hpp>

namespace burin::curves {

/// Which of an edge's two new points comes first: the one nearer to its begin, or (as the paper prints) the other.
enum class DeRhamOrder : std::uint8_t { near, far };
constexpr auto words(DeRhamOrder) {
  return std::array<params::Word<DeRhamOrder>, 2>{{{"near", DeRhamOrder::near}, {"far", DeRhamOrder::far}}};
}

/// Whether the ends of an open curve are cut like other corners or stay where they are.
enum class DeRhamEnds : std::uint8_t { free, clamp };
constexpr auto words(DeRhamEnds) {
  return std::array<params::Word<DeRhamEnds>, 2>{{{"free", DeRhamEnds::free}, {"clamp", DeRhamEnds::clamp}}};
}

/// Generalized de Rham scheme (corner cutting): every edge AB is replaced by the edge from (1-t) A + t B to t A + (1-t)
/// B, and what is left of the corners joins them. Source: Ding & Qi, eq. (1), (2); reference curves C.
struct DeRhamParams {
  SpaceBase base;
  double t = 0.25;
  std::optional<double> lambda;
  DeRhamOrder order = DeRhamOrder::near;
  DeRhamEnds ends = DeRhamEnds::free;
  bool normalize = false;
  int levels = 6;
  std::optional<params::CameraParams> camera;

  static constexpr auto fields() {
    return std::tuple{
        params::field("base", &DeRhamParams::base, "what is refined, as in two-point-3d: in the plane or in space"),
        params::field(
            "t", &DeRhamParams::t,
            "how much of an edge is cut off at either end: 1/4 is Chaikin's, 1/3 de Rham's trisection; converges "
            "for 0 < t < 1, a fractal from 1/2 on"),
        params::field("lambda", &DeRhamParams::lambda, "instead of t = lambda/(2 lambda + 1)"),
        params::field("order", &DeRhamParams::order,
                      "which new point of an edge comes first; far with t is near with 1-t"),
        params::field("ends", &DeRhamParams::ends, "of an open base: cut like corners, or kept"),
        params::field("normalize", &DeRhamParams::normalize,
                      "for t < 0 and t > 1, where the curve grows by |1-2t| a level: shrink by that about the middle"),
        params::field("levels", &DeRhamParams::levels, {0, 1000},
                      "refinement levels; what is drawn is limited by the view"),
        params::field("camera", &DeRhamParams::camera,
                      "how a curve in space is seen; unset: as far as the base is in the plane, not at all")};
  }
};

/// t of the near order, whatever way it was given.
double near_t(const DeRhamParams& params);

/// Joint spectral radius of the differences: the longest edge shrinks like its powers. Below 1, and the curve
/// converges, just for 0 < t < 1. Source: reference curves C.
double de_rham_spectral_radius(double t);

/// The family's row in the catalogue.
Family de_rham_family();

}  // namespace burin::curves
