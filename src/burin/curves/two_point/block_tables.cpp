#include <algorithm>
#include <limits>
#include <utility>

#include <burin/curves/two_point/block_tables.hpp>

namespace burin::curves::two_point {

namespace {

constexpr std::size_t most_block_edges = 1024;
constexpr double infinity = std::numeric_limits<double>::infinity();

void measure_last_level(BlockTable& table) {
  const std::vector<Vec2>& v = table.vertices.back();
  double shortest = infinity;
  double longest = 0.0;
  for (std::size_t w = 0; w + 1 < v.size(); ++w) {
    const double edge = distance(v[w], v[w + 1]);
    shortest = std::min(shortest, edge);
    longest = std::max(longest, edge);
  }
  table.shortest.push_back(shortest);
  table.longest.push_back(longest);
}

void add_level(BlockTable& table, const Automaton& automaton) {
  const std::vector<Vec2>& old_vertices = table.vertices.back();
  const std::vector<std::uint32_t>& old_states = table.states.back();
  std::vector<Vec2> vertices;
  std::vector<std::uint32_t> states;
  for (std::size_t w = 0; w < old_states.size(); ++w) {
    const Automaton::State& state = automaton.states[old_states[w]];
    const Vec2 p = old_vertices[w];
    const Vec2 d = old_vertices[w + 1] - p;
    vertices.push_back(p);
    for (std::size_t j = 1; j + 1 < state.vertices.size(); ++j) {
      vertices.push_back(p + complex_product(state.vertices[j], d));
    }
    states.insert(states.end(), state.children.begin(), state.children.end());
  }
  vertices.push_back(old_vertices.back());
  table.vertices.push_back(std::move(vertices));
  table.states.push_back(std::move(states));
  ++table.depth;
  measure_last_level(table);
}

BlockTable make_table(const Automaton& automaton, std::uint32_t start) {
  BlockTable table{0, {{{0.0, 0.0}, {1.0, 0.0}}}, {{start}}, {}, {}};
  measure_last_level(table);
  do {
    add_level(table, automaton);
    // All edges of a level have equally many children: the count changes by level only.
  } while (table.states.back().size() * automaton.child_count(table.states.back().front()) <= most_block_edges);
  return table;
}

/// The largest over all edges w of level t of bound(|c_w - 1/2|, |r_w|), c_w the midpoint and r_w the edge.
template <class Bound>
double largest(const BlockTables& tables, bool deepest, Bound bound) {
  double found = 0.0;
  for (const BlockTable& table : tables.by_state) {
    const std::vector<Vec2>& v = table.vertices[deepest ? static_cast<std::size_t>(table.depth) : 1];
    for (std::size_t w = 0; w + 1 < v.size(); ++w) {
      const Vec2 middle = 0.5 * (v[w] + v[w + 1]);
      found = std::max(found, bound(distance(middle, {0.5, 0.0}), distance(v[w], v[w + 1])));
    }
  }
  return found;
}

double reach_of(const BlockTables& tables) {
  const auto disc = [](double offset, double ratio) { return ratio < 1.0 ? offset / (1.0 - ratio) : infinity; };
  const double one_level = largest(tables, false, disc);
  const double one_block = largest(tables, true, disc);
  const double reach = std::min(one_level, one_block);
  if (reach == infinity) return infinity;
  const double sharper = largest(tables, true, [&](double offset, double ratio) { return offset + ratio * reach; });
  // A little room for the rounding of these sums.
  return std::min(reach, sharper) * (1.0 + 1e-9);
}

double distance_to_unit_edge(Vec2 p) {
  return distance(p, {std::clamp(p.x, 0.0, 1.0), 0.0});
}

/// The offspring of an edge within h of the unit edge, and r times as long, is within h + r times the deviation. The
/// edge is no farther from its offspring than that from it, for it is connected and has the same ends.
double deviation_of(const BlockTables& tables) {
  if (tables.reach == infinity) return infinity;
  double sharper = 0.0;
  for (const BlockTable& table : tables.by_state) {
    const std::vector<Vec2>& v = table.vertices.back();
    for (std::size_t w = 0; w + 1 < v.size(); ++w) {
      const double apart = std::max(distance_to_unit_edge(v[w]), distance_to_unit_edge(v[w + 1]));
      sharper = std::max(sharper, apart + distance(v[w], v[w + 1]) * tables.reach);
    }
  }
  return std::min(tables.reach, sharper * (1.0 + 1e-9));
}

}  // namespace

BlockTables make_block_tables(Automaton automaton) {
  BlockTables tables{std::move(automaton), {}, 0.0, 0.0};
  for (std::size_t state = 0; state < tables.automaton.states.size(); ++state) {
    tables.by_state.push_back(make_table(tables.automaton, static_cast<std::uint32_t>(state)));
  }
  tables.reach = reach_of(tables);
  tables.deviation = deviation_of(tables);
  return tables;
}

}  // namespace burin::curves::two_point
