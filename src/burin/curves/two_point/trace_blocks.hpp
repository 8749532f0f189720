#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <burin/curves/two_point/block_tables.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::curves::two_point {

/// Walks the refinement of one base edge by block tables, in travel order, with an explicit stack: O(levels) blocks of
/// memory. An edge whose whole offspring is nearer to it than the view's tolerance, or lies outside its box, is not
/// refined; it stands for them itself, which outside the box nobody sees.
template <class Emitter>
class BlockTracer {
 public:
  BlockTracer(const BlockTables& tables, int levels, const View& view, Emitter& emitter)
      : tables_(tables), levels_(levels), view_(view), emitter_(emitter) {}

  /// Emits everything after p up to and including q.
  Flow trace(Vec2 p, Vec2 q, std::uint32_t state) {
    stack_.clear();
    stack_.push_back({p, q, state, 0, 0, 0});
    while (!stack_.empty()) {
      const Node node = stack_.back();
      stack_.pop_back();
      const Flow flow = node.depth == 0 ? visit_block(node) : visit_inside(node);
      if (flow == Flow::stop) return Flow::stop;
    }
    return Flow::go;
  }

 private:
  /// Edge `index` of level `depth` inside the block that hangs on the edge pq.
  struct Node {
    Vec2 p;
    Vec2 q;
    std::uint32_t state;  ///< of the block's root
    std::uint32_t index;
    int level;  ///< of the block's root
    int depth;  ///< 0: the root itself
  };

  /// Whether the offspring of an edge is too near to it, or too far away, to be seen.
  bool unseen(Vec2 p, Vec2 q, double edge_length) const {
    return tables_.deviation * edge_length < view_.tolerance ||
           !view_.box.touches_disc(0.5 * (p + q), tables_.reach * edge_length);
  }

  Flow visit_block(const Node& node) {
    if (node.level == levels_) return emitter_.point(node.q);
    const BlockTable& table = tables_.by_state[node.state];
    const int depth = std::min(table.depth, levels_ - node.level);
    const Vec2 d = node.q - node.p;
    if (!view_.is_limited()) return whole_block(node, table, depth, d);
    const double edge_length = length(d);
    if (unseen(node.p, node.q, edge_length)) return emitter_.point(node.q);
    if (view_.box.contains_disc(0.5 * (node.p + node.q), tables_.reach * edge_length)) {
      // Often every edge of one level falls below the tolerance at once, and none before.
      const double deviation = tables_.deviation * edge_length;
      int stop = 1;
      while (stop <= depth && deviation * table.longest[at(stop)] >= view_.tolerance) ++stop;
      if (deviation * table.shortest[at(stop - 1)] >= view_.tolerance) {
        return stop <= depth ? emitter_.block(table.vertices[at(stop)], node.p, d, node.q)
                             : whole_block(node, table, depth, d);
      }
    }
    push_children(node, table);
    return Flow::go;
  }

  /// All of the block's edges, no view in the way.
  Flow whole_block(const Node& node, const BlockTable& table, int depth, Vec2 d) {
    const std::vector<Vec2>& v = table.vertices[at(depth)];
    if (node.level + depth == levels_) return emitter_.block(v, node.p, d, node.q);
    const std::vector<std::uint32_t>& states = table.states[at(depth)];
    for (std::size_t w = states.size(); w-- > 0;) {
      stack_.push_back({place(node, v, w), place(node, v, w + 1), states[w], 0, node.level + depth, 0});
    }
    return Flow::go;
  }

  Flow visit_inside(const Node& node) {
    const BlockTable& table = tables_.by_state[node.state];
    const std::vector<Vec2>& v = table.vertices[at(node.depth)];
    const Vec2 p = place(node, v, node.index);
    const Vec2 q = place(node, v, node.index + 1);
    const int level = node.level + node.depth;
    if (level == levels_ || unseen(p, q, distance(p, q))) return emitter_.point(q);
    if (node.depth < table.depth) {
      push_children(node, table);
    } else {
      stack_.push_back({p, q, table.states[at(node.depth)][node.index], 0, level, 0});
    }
    return Flow::go;
  }

  /// The next level of the node's edge, still inside its block.
  void push_children(const Node& node, const BlockTable& table) {
    const std::uint32_t state = table.states[at(node.depth)][node.index];
    const auto k = static_cast<std::uint32_t>(tables_.automaton.child_count(state));
    for (std::uint32_t j = k; j-- > 0;) {
      stack_.push_back({node.p, node.q, node.state, node.index * k + j, node.level, node.depth + 1});
    }
  }

  static Vec2 place(const Node& node, const std::vector<Vec2>& v, std::size_t w) {
    if (w + 1 == v.size()) return node.q;
    return w == 0 ? node.p : node.p + complex_product(v[w], node.q - node.p);
  }

  static std::size_t at(int depth) { return static_cast<std::size_t>(depth); }

  const BlockTables& tables_;
  int levels_;
  View view_;
  Emitter& emitter_;
  std::vector<Node> stack_;
};

}  // namespace burin::curves::two_point
