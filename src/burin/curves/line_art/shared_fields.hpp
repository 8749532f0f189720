#pragma once

#include <string_view>
#include <tuple>

#include <burin/params/fields.hpp>

/// The rows of the parameters that a model in the plane and the one in space have alike.
namespace burin::curves::line_art {

inline constexpr int most_lines = 1'000'000;

/// How many polylines there are.
template <class P>
constexpr auto count_fields(std::string_view bundle_doc) {
  using params::field;
  return std::tuple{field("lines", &P::lines, {1, most_lines}, "how many polylines"),
                    field("lines_per_start", &P::lines_per_start, {1, most_lines}, bundle_doc)};
}

/// How a polyline grows.
template <class P>
constexpr auto polyline_fields() {
  using params::field;
  return std::tuple{field("places", &P::places, "how the starting places follow each other in their region"),
                    field("segments", &P::segments, "how many segments a polyline has: one number or [low, high]"),
                    field("length", &P::length, "length of a segment: one number or [low, high]")};
}

/// How polylines are held between regions.
template <class P>
constexpr auto chord_fields(std::string_view offset_doc) {
  using params::field;
  return std::tuple{
      field("to", &P::to, "where they end: a region or a list of them"),
      field("weights", &P::weights, "how often each region of `to` is meant; unset: all alike"),
      field("pairing", &P::pairing,
            "the place at the end: random; the same as at the start, counted in order or crossed; or the nearest of "
            "16"),
      field("places", &P::places, "how the places follow each other in their regions"),
      field("markers", &P::markers, "where an edge is refined, ascending, in (0, 1)"),
      field("levels", &P::levels, {0, 12}, "how often the edges are refined"),
      field("offset", &P::offset, {0.0, 1e6}, offset_doc),
      field("decay", &P::decay, {0.0, 10.0, true, false}, "factor on the offset from each level to the next"),
      field("unit", &P::unit, "offset in lengths of the edge (relative) or in model units (absolute)")};
}

}  // namespace burin::curves::line_art
