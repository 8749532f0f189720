#pragma once

#include <array>
#include <optional>
#include <vector>

#include <burin/curves/family.hpp>
#include <burin/curves/space_base.hpp>
#include <burin/curves/subdivision/four_tap.hpp>
#include <burin/params/camera_params.hpp>

namespace burin::curves {

namespace subdivision {

constexpr auto words(GhostRule) {
  return std::array<params::Word<GhostRule>, 4>{{{"linear", GhostRule::linear},
                                                 {"reflect", GhostRule::reflect},
                                                 {"replicate", GhostRule::replicate},
                                                 {"given", GhostRule::given}}};
}

}  // namespace subdivision

/// Four-parameter four-point scheme: P'_{2i} = lambda P_{i-1} + (1-lambda-mu) P_i + mu P_{i+1}, P'_{2i+1} = (P_i +
/// P_{i+1})/2 + 2 omega (D_i + D_{i+1}) with D_i = P_i - nu P_{i-1} - (1-nu) P_{i+1}.
/// Source: Zhao, Peng & Ye, eq. (1); reference curves E.
struct FourParameterParams {
  SpaceBase base;
  double lambda = 0.0;
  double mu = 0.0;
  double nu = 0.5;
  double omega = 0.0625;
  subdivision::GhostRule ends = subdivision::GhostRule::linear;
  int levels = 6;
  std::optional<params::CameraParams> camera;

  static constexpr auto fields() {
    return std::tuple{
        params::field("base", &FourParameterParams::base,
                      "the control points, as in two-point-3d: in the plane or in space"),
        params::field("lambda", &FourParameterParams::lambda, "how far a point moves to the one before it"),
        params::field(
            "mu", &FourParameterParams::mu,
            "how far a point moves to the one after it; with lambda = mu = 0 the curve passes through the points"),
        params::field("nu", &FourParameterParams::nu, "what bends a new point: 1/2 treats both sides alike"),
        params::field("omega", &FourParameterParams::omega, "how much it is bent: the tension"),
        params::field("ends", &FourParameterParams::ends,
                      "of an open base: how two points beyond each end are made, on a line, by reflection, or the end "
                      "again; given: the base's outermost two at each end are these"),
        params::field("levels", &FourParameterParams::levels, {0, 1000},
                      "refinement levels; what is drawn is limited by the view"),
        params::field("camera", &FourParameterParams::camera,
                      "how a curve in space is seen; unset: as far as the base is in the plane, not at all")};
  }
};

/// The weights a_-3 .. a_3 of the scheme: P'_k = sum_j a_{k-2j} P_j.
std::vector<double> four_parameter_mask(double lambda, double mu, double nu, double omega);

/// What Theorems 1 to 3 of Zhao, Peng & Ye say. They are sufficient conditions only.
struct FourParameterTheorems {
  std::array<double, 3> norms{};  ///< of the difference schemes of C0, C1, C2, to be below 1
  std::array<double, 2> sides{};  ///< side conditions of C1 and of C2, to be 0
  int covered = -1;               ///< the limit is C^covered; -1: no theorem holds

  /// Whether theorem k (1 to 3) may be asked: its side conditions hold.
  bool applies(int k) const;
};

FourParameterTheorems four_parameter_theorems(double lambda, double mu, double nu, double omega);

/// The family's row in the catalogue.
Family four_parameter_family();

}  // namespace burin::curves
