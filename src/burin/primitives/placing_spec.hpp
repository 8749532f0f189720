#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <burin/params/fields.hpp>
#include <burin/primitives/choice.hpp>

/// How a preset says which figures are put where along a curve.
namespace burin::primitives {

enum class PlaceAt : std::uint8_t { points, edges };
constexpr auto words(PlaceAt) {
  return std::array<params::Word<PlaceAt>, 2>{{{"points", PlaceAt::points}, {"edges", PlaceAt::edges}}};
}

/// Which points of a level: all, or those that the level before had not.
enum class PlaceMode : std::uint8_t { all, fresh };
constexpr auto words(PlaceMode) {
  return std::array<params::Word<PlaceMode>, 2>{{{"all", PlaceMode::all}, {"new", PlaceMode::fresh}}};
}

/// Which figures are mirrored on their own x axis: it puts them on the other side of a line that they are turned along.
enum class PlaceMirror : std::uint8_t { none, all, alternate, random };
constexpr auto words(PlaceMirror) {
  return std::array<params::Word<PlaceMirror>, 4>{{{"none", PlaceMirror::none},
                                                   {"all", PlaceMirror::all},
                                                   {"alternate", PlaceMirror::alternate},
                                                   {"random", PlaceMirror::random}}};
}

/// Every so-many-th place, or a length along the curve.
struct Every {
  std::int64_t count = 1;
  double length_mm = 0.0;  ///< above 0: this counts
};

/// The name of a figure that draws nothing.
inline constexpr std::string_view no_figure = "none";

struct PlacingSpec {
  Choice<std::string> use{};
  PlaceAt at = PlaceAt::points;
  Every every;
  PlaceMode mode = PlaceMode::all;
  Choice<PlaceLength> scale{{PlaceLength{constant(5.0)}}};
  Choice<PlaceNumber> rotate{{PlaceNumber{constant(0.0)}}};
  PlaceMirror mirror = PlaceMirror::none;
  params::Length jitter;
  bool distinct = false;
  params::Length apart;
  Choice<PlaceNumber> when{{PlaceNumber{constant(1.0)}}};

  static constexpr auto fields() {
    return std::tuple{
        params::field("use", &PlacingSpec::use,
                      "a figure, a list that takes turns, or { by, at, of }; \"none\" leaves the place empty"),
        params::field("at", &PlacingSpec::at, "the curve's points, or the middles of its edges"),
        params::field("every", &PlacingSpec::every, "3: every third place; \"6mm\": so far along the curve"),
        params::field("mode", &PlacingSpec::mode, "new: only points that the level before had not"),
        params::field("scale", &PlacingSpec::scale,
                      "length of a figure's unit in mm: \"4mm\", \"0.3*length\", \"8*0.6^level\", bands"),
        params::field("rotate", &PlacingSpec::rotate,
                      "turn in degrees: 30, \"edge\", \"tangent + 90\", \"normal\", \"random\", bands"),
        params::field("mirror", &PlacingSpec::mirror,
                      "which figures are mirrored on their x axis, to the other side of the curve"),
        params::field("jitter", &PlacingSpec::jitter, params::not_negative, "moved at random by up to this length"),
        params::field("distinct", &PlacingSpec::distinct, "one figure only where the curve comes by again"),
        params::field("apart", &PlacingSpec::apart, params::not_negative,
                      "least distance between two figures; later ones are left out"),
        params::field("when", &PlacingSpec::when, "placed where this is above 0: an expression or bands")};
  }
};

/// `distinct` tells places apart that lie this far from each other.
inline constexpr double distinct_mm = 1e-3;

/// Makes lists take turns by level, the first at this one.
void turn_by_level(PlacingSpec& spec, int first_level);
/// The variables of all its expressions.
PositionUse variables_used(const PlacingSpec& spec);
/// Whether another seed places otherwise.
bool uses_chance(const PlacingSpec& spec);
/// Whether it matters where in its slot, and in which copy, a curve lies.
bool depends_on_slot(const PlacingSpec& spec);
/// Whether every place gets a figure.
bool fills_every_place(const PlacingSpec& spec);

}  // namespace burin::primitives

namespace burin::params {

template <>
struct ValueType<primitives::Every> {
  static std::string name() { return "whole number or length"; }
  static bool read(const Value& value, primitives::Every& every, ReadContext& context);
  static std::string text(const primitives::Every& every);
};

/// A table of PlacingSpec's fields.
template <>
struct ValueType<primitives::PlacingSpec> {
  static std::string name() { return "table"; }
  static bool read(const Value& value, primitives::PlacingSpec& spec, ReadContext& context);
  static std::string text(const primitives::PlacingSpec&) { return {}; }
};

}  // namespace burin::params
