#include <algorithm>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/curves/two_point/dimension.hpp>

namespace burin::curves::two_point {

std::vector<double> edge_ratios(const std::vector<Mark>& marks) {
  std::vector<double> ratios;
  Vec2 before{0.0, 0.0};
  for (const Mark& mark : marks) {
    BURIN_EXPECT(mark.alpha.is_constant() && mark.beta.is_constant());
    const Vec2 here{mark.alpha.low, mark.beta.low};
    ratios.push_back(distance(before, here));
    before = here;
  }
  ratios.push_back(distance(before, {1.0, 0.0}));
  return ratios;
}

std::optional<double> similarity_dimension(const Motif& motif) {
  const bool is_self_similar = motif.by_level.size() == 1 && motif.by_level.front().by_edge.size() == 1 &&
                               motif.is_constant() && !motif.absolute && motif.decay == 1.0;
  if (!is_self_similar) return std::nullopt;
  const std::vector<double> ratios = edge_ratios(motif.by_level.front().by_edge.front());
  if (std::any_of(ratios.begin(), ratios.end(), [](double r) { return r >= 1.0; })) return std::nullopt;
  // The sum falls with D, from the number of edges to 0; it is at least 1 at D = 1, for a path is no shorter than its
  // chord.
  const auto sum = [&](double dimension) {
    double total = 0.0;
    for (const double r : ratios) total += r > 0.0 ? math::pow(r, dimension) : 0.0;
    return total;
  };
  double low = 1.0;
  double high = 2.0;
  while (sum(high) > 1.0) high *= 2.0;
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (low + high);
    (sum(middle) > 1.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace burin::curves::two_point
