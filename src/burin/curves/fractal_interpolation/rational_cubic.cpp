#include <array>
#include <limits>

#include <burin/curves/fractal_interpolation/rational_cubic.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

/// A cubic by its control points in Bernstein's basis.
using Cubic = std::array<double, 4>;

Cubic numerator(const EndData& ends, Shape shape) {
  return {ends.left, (shape.alpha * ends.left + ends.left_slope) / 3.0,
          (shape.beta * ends.right - ends.right_slope) / 3.0, ends.right};
}

Cubic denominator(Shape shape) {
  return {1.0, shape.alpha / 3.0, shape.beta / 3.0, 1.0};
}

/// The symmetric trilinear form that is the cubic on its diagonal.
double blossom(const Cubic& c, double r, double s, double t) {
  const auto mix = [](double a, double b, double u) { return (1.0 - u) * a + u * b; };
  const double c01 = mix(c[0], c[1], r);
  const double c12 = mix(c[1], c[2], r);
  const double c23 = mix(c[2], c[3], r);
  return mix(mix(c01, c12, s), mix(c12, c23, s), t);
}

/// The control points of the cubic's part over an interval.
Cubic part(const Cubic& c, Interval over) {
  const double a = over.low;
  const double b = over.high;
  return {blossom(c, a, a, a), blossom(c, a, a, b), blossom(c, a, b, b), blossom(c, b, b, b)};
}

/// An upper bound of |(n/q)'| over the part of unit length whose control points these are: the control points of
/// n'q - nq', of degree five, over the least square of q's.
double part_slope_bound(Cubic n, const Cubic& q) {
  // A constant less in n/q leaves the derivative and makes the two products small, so that their difference is sharp.
  const double offset = n[0] / q[0];
  for (std::size_t i = 0; i < 4; ++i) n[i] -= offset * q[i];
  constexpr std::array<double, 3> of_2{1.0, 2.0, 1.0};
  constexpr std::array<double, 4> of_3{1.0, 3.0, 3.0, 1.0};
  constexpr std::array<double, 6> of_5{1.0, 5.0, 10.0, 10.0, 5.0, 1.0};
  std::array<double, 6> product{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double dn = 3.0 * (n[i + 1] - n[i]);
    const double dq = 3.0 * (q[i + 1] - q[i]);
    for (std::size_t j = 0; j < 4; ++j) product[i + j] += of_2[i] * of_3[j] * (dn * q[j] - n[j] * dq);
  }
  double largest = 0.0;
  for (std::size_t k = 0; k < 6; ++k) largest = std::max(largest, std::abs(product[k]) / of_5[k]);
  const double least = *std::min_element(q.begin(), q.end());
  return least > 0.0 ? largest / (least * least) : std::numeric_limits<double>::infinity();
}

/// Branch and bound: every part is either below `found` or halved.
struct SlopeSearch {
  static constexpr double slack = 1.02;
  static constexpr int deepest = 60;

  const EndData& ends;
  Shape shape;
  Cubic n = numerator(ends, shape);
  Cubic q = denominator(shape);
  double found = 0.0;
  double bound = 0.0;

  void search(Interval over, int depth) {
    const double upper = part_slope_bound(part(n, over), part(q, over)) / over.width();
    const double middle = over.middle();
    found = std::max(found, std::abs(combine(weight_slopes_at(middle, shape), ends)));
    if (upper <= slack * found || depth == deepest) {
      bound = std::max(bound, upper);
      return;
    }
    search({over.low, middle}, depth + 1);
    search({middle, over.high}, depth + 1);
  }
};

}  // namespace

Weights weights_at(double theta, Shape shape) {
  const double u = 1.0 - theta;
  const double b0 = u * u * u;
  const double b1 = theta * u * u;
  const double b2 = theta * theta * u;
  const double b3 = theta * theta * theta;
  const double left = b0 + shape.alpha * b1;
  const double right = shape.beta * b2 + b3;
  const double scale = 1.0 / (left + right);
  return {left * scale, right * scale, b1 * scale, -b2 * scale};
}

Weights weight_slopes_at(double theta, Shape shape) {
  const double u = 1.0 - theta;
  const double b1 = theta * u * u;
  const double b2 = theta * theta * u;
  const double c1 = u * u - 2.0 * theta * u;
  const double c2 = 2.0 * theta * u - theta * theta;
  const double left = u * u * u + shape.alpha * b1;
  const double right = shape.beta * b2 + theta * theta * theta;
  const double q = left + right;
  const double left_slope = -3.0 * u * u + shape.alpha * c1;
  const double right_slope = shape.beta * c2 + 3.0 * theta * theta;
  const double q_slope = left_slope + right_slope;
  const double scale = 1.0 / (q * q);
  return {(left_slope * q - left * q_slope) * scale, (right_slope * q - right * q_slope) * scale,
          (c1 * q - b1 * q_slope) * scale, -(c2 * q - b2 * q_slope) * scale};
}

Interval value_range(const EndData& ends, Shape shape, Interval over) {
  // w3 - w4 <= 1/(1 + min(alpha, beta)), so this holds everywhere.
  const double swing =
      std::max(std::abs(ends.left_slope), std::abs(ends.right_slope)) / (1.0 + std::min(shape.alpha, shape.beta));
  const Interval everywhere{std::min(ends.left, ends.right) - swing, std::max(ends.left, ends.right) + swing};
  const Cubic n = part(numerator(ends, shape), over);
  const Cubic q = part(denominator(shape), over);
  Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(q[i] > 0.0)) return everywhere;
    range = hull(range, {n[i] / q[i], n[i] / q[i]});
  }
  return common(everywhere, range);
}

double slope_bound(const EndData& ends, Shape shape) {
  SlopeSearch search{.ends = ends, .shape = shape};
  search.search({0.0, 1.0}, 0);
  return search.bound;
}

}  // namespace burin::curves::fractal_interpolation
