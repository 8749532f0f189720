#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <burin/curves/two_point/motif.hpp>

namespace burin::curves::two_point {

/// The general rule: marks that may be random, expressions, absolute or decaying, each keyed by (seed, level, edge,
/// marker). Slower than the block tables and able to do everything.
class KeyedRule {
 public:
  KeyedRule(const Motif& motif, const std::optional<SignRule>& sign, std::uint64_t seed);

  std::size_t child_count(int level) const { return motif_.stage(level).child_count(); }

  /// The path of edge `edge` (from 0, modulo 2^64) from p to q when `level` (from 1) is made: p, Q_1 ... Q_K, q.
  void path(Vec2 p, Vec2 q, int level, std::uint64_t edge, std::vector<Vec2>& path) const;

  /// Everything that levels after `level` generate from an edge of this length lies within this distance of its
  /// midpoint; infinite when nothing is known. Source: reference curves A.4.
  double reach(int level, double edge_length) const;

  /// And within this distance of the edge itself: how much its chord can hide.
  double detail(int level, double edge_length) const;

 private:
  double value(const Amount& amount, int level, std::uint64_t edge, std::size_t marker, std::uint64_t purpose) const;

  Motif motif_;
  SignRule sign_;
  std::uint64_t seed_;
  double relative_reach_ = 0.0;  ///< of an edge of length 1
  double absolute_reach_ = 0.0;  ///< from its original edge, after level 0
  std::vector<double> decay_powers_;
};

}  // namespace burin::curves::two_point
