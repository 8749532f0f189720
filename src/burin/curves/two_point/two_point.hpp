#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <burin/curves/base_shape.hpp>
#include <burin/curves/family.hpp>
#include <burin/curves/two_point/named_motifs.hpp>

namespace burin::curves {

/// The two-point scheme: every edge is replaced by the motif's path, again and again.
/// Source: Ding & Qi, eq. (4); reference curves A.
struct TwoPointParams {
  BaseShape base;
  two_point::Motif motif = two_point::motif_from(two_point::named_motifs().front());
  std::optional<two_point::SignRule> sign;
  int levels = 5;

  static constexpr auto fields() {
    return std::tuple{
        params::field(
            "base", &TwoPointParams::base,
            "what is refined: segment, triangle, square, { shape = \"ngon\", n = 5 }, { shape = \"star\", ... }, "
            "{ points = [[x, y], ...], closed = true }, { csv = \"file\" } or { path = \"M0 0 ...\" }"),
        params::field("motif", &TwoPointParams::motif, "a name of 'burin list motifs' or of [define], or a table"),
        params::field("sign", &TwoPointParams::sign,
                      "sign of beta over the whole sequence; unset: the motif's own flags or sign"),
        params::field("levels", &TwoPointParams::levels, {0, 1000},
                      "refinement levels; what is drawn is limited by the view")};
  }
};

/// The family's row in the catalogue.
Family two_point_family();

/// A vertex of S_m by its address: a base edge (from 0) and one digit for each level, the coarsest first, which says
/// through which sub-edge of the path one goes. The vertex is the beginning of the last sub-edge.
struct TwoPointAddress {
  std::uint64_t base_edge = 0;
  std::span<const std::uint32_t> digits;  ///< as many as there are levels; digit < number of sub-edges
};

/// The vertex at an address (whatever point of the edges the motif joins), with the bits that draw emits; O(levels).
/// Pre: the address lies within the curve.
Vec2 vertex_at(const TwoPointParams& params, std::uint64_t seed, const TwoPointAddress& address);

/// Vertex n of S_m in travel order, 0 <= n <= edges of S_m (the last is the end point of an open base); nothing
/// outside.
std::optional<Vec2> vertex_at(const TwoPointParams& params, std::uint64_t seed, std::uint64_t n);

}  // namespace burin::curves
