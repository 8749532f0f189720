#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <burin/curves/two_point/motif.hpp>

namespace burin::curves::two_point {

/// B of reference curves A.4: the largest |beta|, when every alpha lies in [0, 1]; else infinite.
double absolute_beta_bound(const std::vector<Mark>& marks);

/// Where a mark is on one edge: along it, and to the right of it before sign and decay.
struct MarkPlace {
  double alpha;
  double beta;
};

/// The general rule: marks that may be random, expressions, absolute or decaying, each keyed by (seed, level, edge,
/// marker). Slower than the block tables and able to do everything.
class KeyedRule {
 public:
  KeyedRule(const Motif& motif, const std::optional<SignRule>& sign, std::uint64_t seed);

  std::size_t child_count(int level) const { return motif_.stage(level).child_count(); }

  const Motif& motif() const { return motif_; }
  /// Mark `marker` (from 1) of an edge; `edge` (from 0) and `level` (from 1) as everywhere here.
  MarkPlace place(const Mark& mark, int level, std::uint64_t edge, std::size_t marker) const;
  /// Of every beta of an edge: its sign and what decay leaves of it.
  double sign_and_decay(int level, std::uint64_t edge) const;
  /// The same without the sign.
  double decay(int level) const { return decay_powers_[static_cast<std::size_t>(level - 1)]; }

  /// The path of edge `edge` (from 0, modulo 2^64) from p to q when `level` (from 1) is made: p, Q_1 ... Q_K, q.
  void path(Vec2 p, Vec2 q, int level, std::uint64_t edge, std::vector<Vec2>& path) const;

  /// Everything that levels after `level` generate from an edge of this length lies within this distance of its
  /// midpoint; infinite when nothing is known. Source: reference curves A.4.
  double reach(int level, double edge_length) const;

  /// And within this distance of the edge itself: how much its chord can hide.
  double detail(int level, double edge_length) const;

 private:
  Motif motif_;
  SignRule sign_;
  std::uint64_t seed_;
  double relative_reach_ = 0.0;  ///< of an edge of length 1
  double absolute_reach_ = 0.0;  ///< from its original edge, after level 0
  std::vector<double> decay_powers_;
};

}  // namespace burin::curves::two_point
