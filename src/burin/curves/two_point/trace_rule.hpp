#pragma once

#include <cstdint>
#include <vector>

#include <burin/path/draw_context.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::curves::two_point {

/// Walks the refinement of one base edge edge by edge, in travel order, with an explicit stack of at most
/// levels * (k - 1) + 1 edges. Rule is KeyedRule's interface: path, reach, detail.
template <class Rule, class Emitter>
class RuleTracer {
 public:
  RuleTracer(const Rule& rule, int levels, const View& view, Emitter& emitter)
      : rule_(rule), levels_(levels), view_(view), emitter_(emitter) {}

  /// Emits everything after p up to and including q. `edge` is the base edge's ordinal, from 0.
  Flow trace(Vec2 p, Vec2 q, std::uint64_t edge) {
    stack_.clear();
    stack_.push_back({p, q, edge, 0});
    while (!stack_.empty()) {
      const Node node = stack_.back();
      stack_.pop_back();
      if (node.level == levels_ || (view_.is_limited() && unseen(node))) {
        if (emitter_.point(node.q) == Flow::stop) return Flow::stop;
        continue;
      }
      rule_.path(node.p, node.q, node.level + 1, node.edge, path_);
      const std::uint64_t k = path_.size() - 1;
      for (std::uint64_t j = k; j-- > 0;) {
        stack_.push_back({path_[j], path_[j + 1], node.edge * k + j, node.level + 1});
      }
    }
    return Flow::go;
  }

 private:
  struct Node {
    Vec2 p;
    Vec2 q;
    std::uint64_t edge;  ///< ordinal over the whole sequence of its level, from 0, modulo 2^64
    int level;
  };

  bool unseen(const Node& node) const {
    const double edge_length = distance(node.p, node.q);
    return rule_.detail(node.level, edge_length) < view_.tolerance ||
           !view_.box.touches_disc(0.5 * (node.p + node.q), rule_.reach(node.level, edge_length));
  }

  const Rule& rule_;
  int levels_;
  View view_;
  Emitter& emitter_;
  std::vector<Node> stack_;
  std::vector<Vec2> path_;
};

}  // namespace burin::curves::two_point
