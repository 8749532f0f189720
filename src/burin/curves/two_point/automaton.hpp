#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <burin/curves/two_point/motif.hpp>

namespace burin::curves::two_point {

/// A self-similar two-point rule as a finite automaton: all that an edge's refinement depends on is its state. Flags
/// give four states (mirrored, reversed); sign rules and marks that change by level or edge give one state for each
/// phase of (level, edge). Source: reference curves A.2.
struct Automaton {
  struct State {
    std::vector<Vec2> vertices;           ///< v_0 = 0, v_1 ... v_k = 1: the edge's path, as factors of the edge vector
    std::vector<std::uint32_t> children;  ///< the states of its k sub-edges
    Vec2 join{};                          ///< the motif's join point, as a factor of the edge vector
  };
  std::vector<State> states;
  std::size_t first_edge_period = 1;  ///< base edge e (from 0) starts in state e mod this

  std::uint32_t start(std::uint64_t base_edge) const {
    return static_cast<std::uint32_t>(base_edge % first_edge_period);
  }
  std::size_t child_count(std::uint32_t state) const { return states[state].children.size(); }
};

/// The automaton of a motif under `sign` (the motif's flags when there is none), or nothing when the rule is not
/// self-similar (random, expressions, absolute beta, decay) or would need more than 256 states.
std::optional<Automaton> make_automaton(const Motif& motif, const std::optional<SignRule>& sign);

}  // namespace burin::curves::two_point
