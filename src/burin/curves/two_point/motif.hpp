#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <burin/curves/two_point/amount.hpp>
#include <burin/curves/two_point/sign_rule.hpp>
#include <burin/geom/vec2.hpp>
#include <burin/params/fields.hpp>
#include <burin/params/read_value.hpp>

namespace burin::curves::two_point {

/// Marker j of an edge: how far along (alpha) and how far to the right of travel (beta, y up). Source: Ding & Qi, eq.
/// (4).
struct Mark {
  Amount alpha;
  Amount beta;
};

/// The marks of one level: one list for each edge in turn (edge i uses list (i-1) mod count); all are equally long.
struct Stage {
  std::vector<std::vector<Mark>> by_edge;

  std::size_t mark_count() const { return by_edge.front().size(); }
  std::size_t child_count() const { return mark_count() + 1; }
};

/// The generator of the two-point scheme: marks for the levels in turn (level m uses stage (m-1) mod count), and either
/// a sign rule over the whole sequence or flags by which each sub-edge is mirrored or built from its far end.
struct Motif {
  std::vector<Stage> by_level;
  std::vector<std::uint8_t> flip{};     ///< empty, or one for each sub-edge: 1 mirrors
  std::vector<std::uint8_t> reverse{};  ///< empty, or one for each sub-edge: 1 builds from the far end
  std::optional<SignRule> sign{};
  bool absolute = false;       ///< beta in model units instead of edge lengths
  double decay = 1.0;          ///< factor on beta from each level to the next
  std::optional<Vec2> join{};  ///< drawn: this point (alpha, beta) of every edge, in place of the vertices
  std::string text = "table";

  bool has_flags() const { return !flip.empty() || !reverse.empty(); }
  const Stage& stage(int level) const { return by_level[static_cast<std::size_t>(level - 1) % by_level.size()]; }
  /// The marks of edge `edge` (from 0, modulo 2^64) when `level` (from 1) is made.
  const std::vector<Mark>& marks(int level, std::uint64_t edge) const {
    const Stage& of_level = stage(level);
    return of_level.by_edge[edge % of_level.by_edge.size()];
  }
  /// Whether every amount is a constant.
  bool is_constant() const;
  /// Whether an amount depends on the seed.
  bool is_random() const;
};

/// The keys of a motif written as a table, for help and docs.
std::vector<params::FieldInfo> motif_fields();

}  // namespace burin::curves::two_point

/// A name ("koch", or one written in [define]) or a table with one of
///   name = "cesaro" with angle, where the motif is a turtle word,
///   marks = [[alpha, beta], ...], points = [[x, y], ...] (vertices, y up, first to last), turtle = "F+F--F+F" with
///   angle, by_level = [motif, ...], by_edge = [marks, ...]
/// and sign, flip, reverse, beta = "absolute", decay, join.
template <>
struct burin::params::ValueType<burin::curves::two_point::Motif> {
  static std::string name() { return "motif"; }
  static bool read(const Value& value, burin::curves::two_point::Motif& motif, ReadContext& context);
  static std::string text(const burin::curves::two_point::Motif& motif) { return motif.text; }
};
