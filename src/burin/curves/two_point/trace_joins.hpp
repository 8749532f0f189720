#pragma once

#include <cstdint>
#include <vector>

#include <burin/curves/two_point/automaton.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::curves::two_point {

/// Walks the refinement of one base edge to its last level and emits the join point of every edge there, in travel
/// order, with an explicit stack of at most levels * (k - 1) + 1 edges.
template <class Emitter>
class JoinTracer {
 public:
  JoinTracer(const Automaton& automaton, int levels, Emitter& emitter)
      : automaton_(automaton), levels_(levels), emitter_(emitter) {}

  Flow trace(Vec2 p, Vec2 q, std::uint32_t start) {
    stack_.clear();
    stack_.push_back({p, q, start, 0});
    while (!stack_.empty()) {
      const Node node = stack_.back();
      stack_.pop_back();
      const Automaton::State& state = automaton_.states[node.state];
      const Vec2 d = node.q - node.p;
      if (node.level == levels_) {
        if (emitter_.point(node.p + complex_product(state.join, d)) == Flow::stop) return Flow::stop;
        continue;
      }
      Vec2 end = node.q;
      for (std::size_t j = state.children.size(); j-- > 0;) {
        const Vec2 begin = j == 0 ? node.p : node.p + complex_product(state.vertices[j], d);
        stack_.push_back({begin, end, state.children[j], node.level + 1});
        end = begin;
      }
    }
    return Flow::go;
  }

 private:
  struct Node {
    Vec2 p;
    Vec2 q;
    std::uint32_t state;
    int level;
  };

  const Automaton& automaton_;
  int levels_;
  Emitter& emitter_;
  std::vector<Node> stack_;
};

}  // namespace burin::curves::two_point
