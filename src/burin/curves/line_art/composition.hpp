#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <burin/curves/line_art/region.hpp>
#include <burin/curves/line_art/values.hpp>
#include <burin/curves/smoothing.hpp>
#include <burin/params/fields.hpp>

namespace burin::curves::line_art {

/// What becomes of a polyline that meets a shape, another stroke or full tone.
enum class Meet : std::uint8_t {
  end,    ///< it ends there
  drop,   ///< it is left out
  resume  ///< what lies behind goes on as a stroke of its own
};

constexpr auto words(Meet) {
  return std::array<params::Word<Meet>, 3>{{{"end", Meet::end}, {"drop", Meet::drop}, {"resume", Meet::resume}}};
}

/// Which polylines become strokes, and how much of them. Earlier polylines win; later ones never change them.
struct Composition {
  LineFunction density;
  LineFunction kind;
  Smoothing smooth = Smoothing::none;
  int smooth_levels = 3;
  std::optional<Region> inside;
  Regions keep_out;
  double spacing = 0.0;
  FieldFunction tone;
  std::optional<double> pen_width;
  double shortest = 0.0;
  std::optional<Meet> meet;
  std::optional<double> budget;

  static constexpr auto fields() {
    using params::field;
    return std::tuple{
        field("density", &Composition::density,
              "chance of a polyline to be drawn, 0 to 1, by x, y, r, phi of its first point, span and angle of its "
              "chord, index, rand, in space also depth: how far beyond the camera's target its middle lies"),
        field("kind", &Composition::kind, "`level` of its strokes for the pen's bands, 0 to 65535, by the same"),
        field("smooth", &Composition::smooth,
              "round the polylines: corners cuts them, four-point runs through the given points"),
        field("smooth_levels", &Composition::smooth_levels, {0, 8}, "how often they are refined for that"),
        field("inside", &Composition::inside, "strokes stay inside this rectangle, disc, ring or polygon"),
        field("keep_out", &Composition::keep_out, "strokes stay out of these"),
        field("spacing", &Composition::spacing, params::not_negative,
              "least distance between strokes in model units; 0: none"),
        field("tone", &Composition::tone,
              "share of the paper to be inked, 0 to 0.95, by x, y, r, phi; needs `pen_width` and plenty of lines"),
        field("pen_width", &Composition::pen_width, params::positive, "width of the pen in model units, for `tone`"),
        field("shortest", &Composition::shortest, params::not_negative, "strokes shorter than this are left out"),
        field("meet", &Composition::meet,
              "at a shape, another stroke or full tone: end there, drop the polyline, or resume behind; unset: end, "
              "between regions drop"),
        field("budget", &Composition::budget, params::not_negative,
              "total length of the strokes in model units; the one that passes it is the last")};
  }

  /// Whether every polyline is drawn as it comes, only smoothed.
  bool keeps_all() const {
    return !density && !inside && keep_out.all.empty() && spacing == 0.0 && !tone && shortest == 0.0 && !budget;
  }
  bool uses_seed() const { return density || kind.uses_chance() || tone.uses_chance(); }
};
static_assert(params::ParamStruct<Composition>);

}  // namespace burin::curves::line_art

template <>
struct burin::params::ValueType<burin::curves::line_art::Composition> {
  static std::string name() { return "composition"; }
  static bool read(const Value& value, burin::curves::line_art::Composition& composition, ReadContext& context);
  static std::string text(const burin::curves::line_art::Composition&) { return {}; }
};
