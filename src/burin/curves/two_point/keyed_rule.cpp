#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <burin/base/math.hpp>
#include <burin/base/random.hpp>
#include <burin/curves/two_point/keyed_rule.hpp>

namespace burin::curves::two_point {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What a draw is for: the last key of its random number.
constexpr std::uint64_t alpha_purpose = 1;
constexpr std::uint64_t beta_purpose = 2;

/// max over sub-edges of |c_j - 1/2| / (1 - |r_j|), each bounded over its marks' ranges and both signs.
double disc_of(const std::vector<Mark>& marks) {
  const auto corner = [&](std::size_t j) -> std::array<Interval, 2> {
    if (j == 0) return {{{0.0, 0.0}, {0.0, 0.0}}};
    if (j > marks.size()) return {{{1.0, 1.0}, {0.0, 0.0}}};
    return {marks[j - 1].alpha.range(), marks[j - 1].beta.range()};
  };
  double disc = 0.0;
  for (std::size_t j = 0; j <= marks.size(); ++j) {
    const auto [a0, b0] = corner(j);
    const auto [a1, b1] = corner(j + 1);
    const Vec2 ratio{largest_magnitude({a1.low - a0.high, a1.high - a0.low}),
                     largest_magnitude({b1.low - b0.high, b1.high - b0.low})};
    const Vec2 offset{largest_magnitude({0.5 * (a0.low + a1.low) - 0.5, 0.5 * (a0.high + a1.high) - 0.5}),
                      largest_magnitude({0.5 * (b0.low + b1.low), 0.5 * (b0.high + b1.high)})};
    if (!(length(ratio) < 1.0)) return infinity;
    disc = std::max(disc, length(offset) / (1.0 - length(ratio)));
  }
  return disc;
}

template <class Bound>
double largest_over_marks(const Motif& motif, Bound bound) {
  double found = 0.0;
  for (const Stage& stage : motif.by_level) {
    for (const std::vector<Mark>& marks : stage.by_edge) found = std::max(found, bound(marks));
  }
  return found;
}

}  // namespace

double absolute_beta_bound(const std::vector<Mark>& marks) {
  double bound = 0.0;
  for (const Mark& mark : marks) {
    const Interval alpha = mark.alpha.range();
    if (!(alpha.low >= 0.0 && alpha.high <= 1.0)) return infinity;
    bound = std::max(bound, largest_magnitude(mark.beta.range()));
  }
  return bound;
}

KeyedRule::KeyedRule(const Motif& motif, const std::optional<SignRule>& sign, std::uint64_t seed)
    : motif_(motif), sign_(sign.value_or(motif.sign.value_or(SignRule{}))), seed_(seed) {
  if (motif_.absolute) {
    absolute_reach_ =
        motif_.decay < 1.0 ? largest_over_marks(motif_, absolute_beta_bound) / (1.0 - motif_.decay) : infinity;
  } else {
    // A smaller beta only shrinks both the ratios and the offsets.
    relative_reach_ = motif_.decay <= 1.0 ? largest_over_marks(motif_, disc_of) * (1.0 + 1e-9) : infinity;
  }
  constexpr int most_levels = 1001;
  double power = 1.0;
  for (int level = 0; level < most_levels; ++level, power *= motif_.decay) decay_powers_.push_back(power);
}

MarkPlace KeyedRule::place(const Mark& mark, int level, std::uint64_t edge, std::size_t marker) const {
  return {mark.alpha.at(seed_, {level, edge, marker, alpha_purpose}),
          mark.beta.at(seed_, {level, edge, marker, beta_purpose})};
}

double KeyedRule::sign_and_decay(int level, std::uint64_t edge) const {
  return sign_(seed_, level, edge) * decay(level);
}

void KeyedRule::path(Vec2 p, Vec2 q, int level, std::uint64_t edge, std::vector<Vec2>& path) const {
  const std::vector<Mark>& marks = motif_.marks(level, edge);
  const Vec2 d = q - p;
  Vec2 right{d.y, -d.x};
  if (motif_.absolute) {
    const double norm = length(d);
    right = norm > 0.0 ? Vec2{right.x / norm, right.y / norm} : Vec2{};
  }
  const double factor = sign_and_decay(level, edge);
  path.clear();
  path.push_back(p);
  for (std::size_t j = 0; j < marks.size(); ++j) {
    const auto [alpha, beta] = place(marks[j], level, edge, j + 1);
    path.push_back(p + alpha * d + factor * beta * right);
  }
  path.push_back(q);
}

double KeyedRule::reach(int level, double edge_length) const {
  return motif_.absolute ? 0.5 * edge_length + detail(level, edge_length) : relative_reach_ * edge_length;
}

double KeyedRule::detail(int level, double edge_length) const {
  return motif_.absolute ? absolute_reach_ * decay_powers_[static_cast<std::size_t>(level)]
                         : relative_reach_ * edge_length;
}

}  // namespace burin::curves::two_point
