#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <burin/curves/two_point/automaton.hpp>

namespace burin::curves::two_point {

/// Several levels of one state at once, on the unit edge: placing a table on an edge is one complex product a point.
struct BlockTable {
  int depth = 0;                                   ///< levels in the table, at least 1
  std::vector<std::vector<Vec2>> vertices;         ///< [t]: the vertices after t levels, 0 first, 1 last
  std::vector<std::vector<std::uint32_t>> states;  ///< [t]: the states of the edges between them
  std::vector<double> shortest;                    ///< [t]: length of the shortest of those edges
  std::vector<double> longest;                     ///< [t]: and of the longest
};

/// The block schedule of an automaton. Levels are taken in blocks counted from the root, as many as give at most 1024
/// edges; every point's bits follow from the tables of the blocks above it, so that a run with another view or more
/// levels gives the same bits for the points it shares.
struct BlockTables {
  Automaton automaton;
  std::vector<BlockTable> by_state;
  /// Everything generated from an edge PQ lies within reach |PQ| of its midpoint, whatever its state; infinite when the
  /// rule does not contract. Source: reference curves A.4.
  double reach = 0.0;
  /// None of it lies farther than deviation |PQ| from the edge itself, or the edge from it: what is lost where the edge
  /// is drawn in its place. At most reach.
  double deviation = 0.0;
};

BlockTables make_block_tables(Automaton automaton);

}  // namespace burin::curves::two_point
