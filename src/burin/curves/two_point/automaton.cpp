#include <algorithm>
#include <numeric>

#include <burin/curves/two_point/automaton.hpp>

namespace burin::curves::two_point {

namespace {

constexpr std::size_t most_states = 256;

/// v_j = alpha_j - i sign beta_j, with the edge's ends.
std::vector<Vec2> path_vertices(const std::vector<Mark>& marks, double sign) {
  std::vector<Vec2> vertices{{0.0, 0.0}};
  for (const Mark& mark : marks) vertices.push_back({mark.alpha.low, -(sign * mark.beta.low)});
  vertices.push_back({1.0, 0.0});
  return vertices;
}

/// The join point of an edge whose betas have this sign.
Vec2 join_point(const Motif& motif, double sign) {
  return motif.join ? Vec2{motif.join->x, -(sign * motif.join->y)} : Vec2{};
}

/// State 2r + f: f mirrored, r built from the far end.
Automaton flags_automaton(const Motif& motif) {
  const std::vector<Mark>& marks = motif.by_level.front().by_edge.front();
  const std::size_t k = marks.size() + 1;
  const auto flag = [](const std::vector<std::uint8_t>& flags, std::size_t j) -> unsigned {
    return flags.empty() ? 0U : flags[j];
  };
  Automaton automaton;
  for (unsigned state = 0; state < 4; ++state) {
    const unsigned f = state & 1U;
    const unsigned r = state >> 1U;
    const double sign = f != 0 ? -1.0 : 1.0;
    Automaton::State made{path_vertices(marks, sign), {}, join_point(motif, sign)};
    for (std::size_t j = 0; j < k; ++j) {
      made.children.push_back(((r ^ flag(motif.reverse, j)) << 1U) | (f ^ flag(motif.flip, j)));
    }
    if (r != 0) {
      std::reverse(made.vertices.begin(), made.vertices.end());
      for (Vec2& v : made.vertices) v = {1.0 - v.x, -v.y};
      made.join = {1.0 - made.join.x, -made.join.y};
      std::reverse(made.children.begin(), made.children.end());
    }
    automaton.states.push_back(std::move(made));
  }
  return automaton;
}

/// State phase_of_level * edges + phase_of_edge.
std::optional<Automaton> rule_automaton(const Motif& motif, const SignRule& sign) {
  std::size_t edges = sign.edge_period();
  for (const Stage& stage : motif.by_level) {
    edges = std::lcm(edges, stage.by_edge.size());
    if (edges > most_states) return std::nullopt;
  }
  const std::size_t levels = std::lcm(sign.level_period(), motif.by_level.size());
  if (levels > most_states || levels * edges > most_states) return std::nullopt;
  Automaton automaton;
  automaton.first_edge_period = edges;
  for (std::size_t level = 0; level < levels; ++level) {
    const Stage& stage = motif.by_level[level % motif.by_level.size()];
    for (std::size_t edge = 0; edge < edges; ++edge) {
      const double s = sign(0, static_cast<int>(level) + 1, edge);
      Automaton::State made{path_vertices(stage.by_edge[edge % stage.by_edge.size()], s), {}, join_point(motif, s)};
      for (std::size_t j = 0; j < stage.child_count(); ++j) {
        const std::size_t child_edge = (edge * stage.child_count() + j) % edges;
        made.children.push_back(static_cast<std::uint32_t>((level + 1) % levels * edges + child_edge));
      }
      automaton.states.push_back(std::move(made));
    }
  }
  return automaton;
}

}  // namespace

std::optional<Automaton> make_automaton(const Motif& motif, const std::optional<SignRule>& sign) {
  if (motif.absolute || motif.decay != 1.0 || !motif.is_constant()) return std::nullopt;
  const std::optional<SignRule>& rule = sign ? sign : motif.sign;
  if (!rule && motif.has_flags()) return flags_automaton(motif);
  if (rule && rule->kind == SignRule::Kind::random) return std::nullopt;
  return rule_automaton(motif, rule.value_or(SignRule{}));
}

}  // namespace burin::curves::two_point
