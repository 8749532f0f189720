#include <algorithm>
#include <variant>

#include <burin/curves/line_art/line_art_3d.hpp>
#include <burin/curves/line_art/space_models.hpp>
#include <burin/curves/line_art/stroke_family.hpp>

namespace burin::curves {

namespace line_art {

namespace {

struct SpacePolylineFamily : StrokeFamily<LineArt3dParams, SpacePolylineModel> {
  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    if (params.heading && *params.heading == Vec3{}) {
      context.report(table.find("heading")->where, "'heading' is a direction; [0, 0, 0] is none");
      return false;
    }
    if (params.spread > 0.0 && !params.heading) {
      context.report(table.find("spread")->where, "'spread' is about 'heading', which is missing");
      return false;
    }
    return check_segments(params.segments, params.length, params.compose, table, context);
  }

  static bool uses_seed(const Params& params) {
    return !params.heading || params.spread > 0.0 || params.turn > 0.0 || !params.start.is_spot() ||
           params.segments.low < params.segments.high || params.length.low < params.length.high ||
           params.compose.uses_seed();
  }
};

struct SpaceBoundaryFamily : StrokeFamily<LineArtBoundary3dParams, SpaceBoundaryModel> {
  static bool check(const Params& params, const params::Table& table, params::ReadContext& context) {
    return check_boundary(params.weights, params.to.all.size(), params.markers, params.levels, params.compose, table,
                          context);
  }

  static bool uses_seed(const Params& params) {
    const bool random_ends = params.to.all.size() > 1 || !params.from.is_spot() || !params.to.all.front().is_spot();
    const bool random_offsets = params.offset > 0.0 && params.levels > 0 && !params.markers.empty();
    return random_ends || random_offsets || params.compose.uses_seed();
  }
};

}  // namespace

}  // namespace line_art

Family line_art_3d_family() {
  return make_family<line_art::SpacePolylineFamily>(
      "line-art-3d", "line art in space: thousands of random polylines through a camera",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, section 5, properties (1) to (4), in space",
      "lines");
}

Family line_art_boundary_3d_family() {
  return make_family<line_art::SpaceBoundaryFamily>(
      "line-art-boundary-3d", "line art in space, held between two regions: chords refined by random offsets",
      "Ding & Qi, Recursive Refinement Algorithm of Fractal Generation, section 5, boundary model, in space", "lines");
}

}  // namespace burin::curves
