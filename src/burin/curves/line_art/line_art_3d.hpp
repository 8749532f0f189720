#pragma once

#include <optional>
#include <vector>

#include <burin/curves/line_art/composition.hpp>
#include <burin/curves/line_art/line_art.hpp>
#include <burin/curves/line_art/space_region.hpp>
#include <burin/params/camera_params.hpp>

namespace burin::curves {

/// The polyline model in space: turns about random axes. Source: reference curves G.3.
struct LineArt3dParams {
  int lines = 400;
  int lines_per_start = 1;
  line_art::SpaceRegion start{line_art::SpaceSpotRegion{}};
  line_art::Places places = line_art::Places::random;
  line_art::CountRange segments{8, 14};
  line_art::NumberRange length{0.02, 0.08};
  double turn = 25.0;
  std::optional<Vec3> heading;
  double spread = 0.0;
  params::CameraParams camera;
  line_art::Composition compose;

  static constexpr auto fields() {
    using P = LineArt3dParams;
    using params::field;
    return std::tuple_cat(
        line_art::count_fields<P>("so many polylines begin at each place, as a bundle"),
        std::tuple{
            field("start", &P::start, "where they begin: [x, y, z], or a region such as { ball = [0, 0, 0, 1] }")},
        line_art::polyline_fields<P>(),
        std::tuple{
            field("turn", &P::turn, {0.0, 180.0}, "greatest turn from one segment to the next, in degrees"),
            field("heading", &P::heading, "first direction [x, y, z]; unset: any"),
            field("spread", &P::spread, {0.0, 180.0}, "how far the first direction may lie off `heading`, in degrees"),
            field("camera", &P::camera, "how it is seen"),
            field("compose", &P::compose,
                  "which polylines become strokes: density, spacing, tone and more, in the picture")});
  }
};

/// The boundary model in space: chords refined by offsets in random directions across. Source: reference curves G.3.
struct LineArtBoundary3dParams {
  int lines = 300;
  int lines_per_start = 1;
  line_art::SpaceRegion from{line_art::SpaceSegmentRegion{{-1.0, 0.0, -0.5}, {-1.0, 0.0, 0.5}}};
  line_art::SpaceRegions to{{line_art::SpaceRegion{line_art::SpaceSegmentRegion{{1.0, -0.5, 0.0}, {1.0, 0.5, 0.0}}}}};
  std::vector<double> weights;
  line_art::Pairing pairing = line_art::Pairing::random;
  line_art::Places places = line_art::Places::random;
  std::vector<double> markers{1.0 / 3.0, 2.0 / 3.0};
  int levels = 2;
  double offset = 0.25;
  double decay = 1.0;
  line_art::Offset unit = line_art::Offset::relative;
  params::CameraParams camera;
  line_art::Composition compose;

  static constexpr auto fields() {
    using P = LineArtBoundary3dParams;
    using params::field;
    return std::tuple_cat(
        line_art::count_fields<P>("so many polylines have both ends in common, as a bundle"),
        std::tuple{
            field("from", &P::from, "where they begin: [x, y, z], or a region such as { along = { knot = [2, 3] } }")},
        line_art::chord_fields<P>("greatest offset of a marker from its edge, in any direction across"),
        std::tuple{field("camera", &P::camera, "how it is seen"),
                   field("compose", &P::compose,
                         "which polylines become strokes: density, spacing, tone and more, in the picture")});
  }
};

/// The families' rows in the catalogue.
Family line_art_3d_family();
Family line_art_boundary_3d_family();

}  // namespace burin::curves
