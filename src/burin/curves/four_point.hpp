#pragma once

#include <array>
#include <optional>

#include <burin/curves/family.hpp>
#include <burin/curves/space_base.hpp>
#include <burin/curves/subdivision/four_tap.hpp>
#include <burin/params/camera_params.hpp>

namespace burin::curves {

/// How the four-point scheme makes the point before the first and after the last of an open curve, at each level.
enum class FourPointEnds : std::uint8_t { linear, reflect, replicate };
constexpr auto words(FourPointEnds) {
  return std::array<params::Word<FourPointEnds>, 3>{{{"linear", FourPointEnds::linear},
                                                     {"reflect", FourPointEnds::reflect},
                                                     {"replicate", FourPointEnds::replicate}}};
}

/// Four-point scheme: points stay, and between P_i and P_{i+1} comes (1-t) (P_i + P_{i+1})/2 + t (P_{i-1} + P_{i+2})/2.
/// Source: Ding & Qi, eq. (3); Dyn, Gregory & Levin 1987 with w = -t/2; reference curves D.
struct FourPointParams {
  SpaceBase base;
  double t = -0.125;
  std::optional<double> w;
  FourPointEnds ends = FourPointEnds::linear;
  int levels = 6;
  std::optional<params::CameraParams> camera;

  static constexpr auto fields() {
    return std::tuple{
        params::field("base", &FourPointParams::base,
                      "the points to pass through, as in two-point-3d: in the plane or in space"),
        params::field(
            "t", &FourPointParams::t,
            "weight of the outer points: smooth for -0.37 <= t < 0 (-1/8 is the classical one), a fractal for 0 "
            "< t < 1 and -1 < t < -0.385"),
        params::field("w", &FourPointParams::w, "instead of t = -2 w: the tension"),
        params::field(
            "ends", &FourPointParams::ends,
            "of an open base: how the point beyond an end is made, on a line, by reflection, or the end again"),
        params::field("levels", &FourPointParams::levels, {0, 1000},
                      "refinement levels; what is drawn is limited by the view"),
        params::field("camera", &FourPointParams::camera,
                      "how a curve in space is seen; unset: as far as the base is in the plane, not at all")};
  }
};

/// t, whatever way it was given.
double four_point_t(const FourPointParams& params);

/// The family's row in the catalogue.
Family four_point_family();

}  // namespace burin::curves
