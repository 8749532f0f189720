#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <burin/curves/family.hpp>
#include <burin/curves/line_art/composition.hpp>
#include <burin/curves/line_art/shared_fields.hpp>

namespace burin::curves {

namespace line_art {

/// Which way a polyline grows from its start.
enum class Grow : std::uint8_t { forward, both };

constexpr auto words(Grow) {
  return std::array<params::Word<Grow>, 2>{{{"forward", Grow::forward}, {"both", Grow::both}}};
}

/// Which place of the target belongs to a place of the first region.
enum class Pairing : std::uint8_t { random, ordered, crossed, nearest };

constexpr auto words(Pairing) {
  return std::array<params::Word<Pairing>, 4>{{{"random", Pairing::random},
                                               {"ordered", Pairing::ordered},
                                               {"crossed", Pairing::crossed},
                                               {"nearest", Pairing::nearest}}};
}

/// What an offset is measured in.
enum class Offset : std::uint8_t { relative, absolute };

constexpr auto words(Offset) {
  return std::array<params::Word<Offset>, 2>{{{"relative", Offset::relative}, {"absolute", Offset::absolute}}};
}

inline constexpr double most_points_a_line = 1 << 20;

}  // namespace line_art

/// The polyline model: many random polylines, each bounded in its number of segments, their lengths and its turns.
/// Source: reference curves G.1, properties (1) to (4).
struct LineArtParams {
  std::optional<int> lines;
  std::optional<int> starts;
  int lines_per_start = 1;
  line_art::Region start{line_art::SpotRegion{{0.0, 0.0}}};
  line_art::Places places = line_art::Places::random;
  line_art::CountRange segments{8, 14};
  line_art::NumberRange length{0.02, 0.08};
  double turn = 25.0;
  std::optional<double> heading;
  double spread = 0.0;
  line_art::FieldFunction flow;
  double follow = 1.0;
  line_art::Grow grow = line_art::Grow::forward;
  line_art::FieldFunction stretch;
  line_art::Composition compose;

  static constexpr auto fields() {
    using P = LineArtParams;
    using params::field;
    return std::tuple_cat(
        std::tuple{
            field("lines", &P::lines, {1, line_art::most_lines}, "how many polylines; unset: 400"),
            field("starts", &P::starts, {1, line_art::most_lines}, "how many starting places, instead of `lines`"),
            field("lines_per_start", &P::lines_per_start, {1, line_art::most_lines},
                  "so many polylines begin at each place, as a bundle"),
            field("start", &P::start,
                  "where they begin: [x, y], [x0, y0, x1, y1], or a region such as { disc = [0, 0, 1] }")},
        line_art::polyline_fields<P>(),
        std::tuple{
            field("turn", &P::turn, {0.0, 3600.0}, "greatest turn from one segment to the next, in degrees"),
            field("heading", &P::heading,
                  "first direction in degrees; unset: any, the same for a bundle when `spread` is given"),
            field("spread", &P::spread, {0.0, 360.0}, "how far the first direction may lie off, in degrees"),
            field("flow", &P::flow,
                  "direction at each point in degrees, by x, y, r, phi, t, index, rand; polylines end where it is no "
                  "number"),
            field("follow", &P::follow, {0.0, 1.0},
                  "how much of the way to the flow each turn makes good; 0: only the first direction is the flow's"),
            field("grow", &P::grow, "forward from the start, or both ways with the start in the middle"),
            field("stretch", &P::stretch,
                  "factor on the length of a segment, by x, y, r, phi, t, index, rand; polylines end where it is not "
                  "above 0"),
            field("compose", &P::compose, "which polylines become strokes: density, spacing, tone and more")});
  }

  int line_count() const { return starts ? *starts * lines_per_start : lines.value_or(400); }
};

/// The boundary model: polylines held between two regions, their chords refined by random offsets.
/// Source: reference curves G.2.
struct LineArtBoundaryParams {
  int lines = 300;
  int lines_per_start = 1;
  line_art::Region from{line_art::SegmentRegion{{0.0, 0.0}, {0.0, 1.0}}};
  line_art::Regions to{{line_art::Region{line_art::SegmentRegion{{2.0, 0.0}, {2.0, 1.0}}}}};
  std::vector<double> weights;
  line_art::Pairing pairing = line_art::Pairing::random;
  line_art::Places places = line_art::Places::random;
  std::vector<double> markers{1.0 / 3.0, 2.0 / 3.0};
  int levels = 2;
  double offset = 0.25;
  double decay = 1.0;
  line_art::Offset unit = line_art::Offset::relative;
  line_art::FieldFunction wander;
  line_art::Composition compose;

  static constexpr auto fields() {
    using P = LineArtBoundaryParams;
    using params::field;
    return std::tuple_cat(
        line_art::count_fields<P>("so many polylines have both ends in common, as a bundle"),
        std::tuple{field("from", &P::from,
                         "where they begin: [x, y], [x0, y0, x1, y1], or a region such as { ring = [0, 0, 1, 2] }")},
        line_art::chord_fields<P>("greatest offset of a marker to either side of its edge"),
        std::tuple{field("wander", &P::wander,
                         "factor on the offset, by x, y, r, phi of the marker, t along the polyline, index, rand"),
                   field("compose", &P::compose, "which polylines become strokes: density, spacing, tone and more")});
  }
};

/// The families' rows in the catalogue.
Family line_art_family();
Family line_art_boundary_family();

}  // namespace burin::curves
