#include <burin/base/math.hpp>
#include <burin/curves/fractal_interpolation/scaling.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

/// Clenshaw's recurrence.
double chebyshev_sum(const std::vector<double>& c, double u) {
  double b1 = 0.0;
  double b2 = 0.0;
  for (std::size_t k = c.size() - 1; k > 0; --k) {
    const double b = c[k] + 2.0 * u * b1 - b2;
    b2 = b1;
    b1 = b;
  }
  return c[0] + u * b1 - b2;
}

}  // namespace

Scaling constant_scaling(double s) {
  return {Scaling::Kind::chebyshev, {s}};
}

double scaling_at(const Scaling& scaling, double theta) {
  const std::vector<double>& c = scaling.c;
  switch (scaling.kind) {
    case Scaling::Kind::chebyshev:
      return c.size() == 1 ? c[0] : chebyshev_sum(c, 2.0 * theta - 1.0);
    case Scaling::Kind::sine:
      return c[0] + c[1] * math::sin(c[2] * theta + c[3]);
    case Scaling::Kind::exponential:
      return c[0] * math::exp(c[1] * theta);
  }
  return 0.0;
}

double sup_bound(const Scaling& scaling) {
  const std::vector<double>& c = scaling.c;
  switch (scaling.kind) {
    case Scaling::Kind::chebyshev: {
      double sum = 0.0;
      for (const double coefficient : c) sum += std::abs(coefficient);
      return sum;
    }
    case Scaling::Kind::sine:
      return std::abs(c[0]) + std::abs(c[1]);
    case Scaling::Kind::exponential:
      return std::abs(c[0]) * std::max(1.0, math::exp(c[1]));
  }
  return 0.0;
}

double lipschitz_bound(const Scaling& scaling) {
  const std::vector<double>& c = scaling.c;
  switch (scaling.kind) {
    case Scaling::Kind::chebyshev: {
      double sum = 0.0;
      // |T_k'| <= k^2, and 2 theta - 1 runs twice as fast as theta.
      for (std::size_t k = 1; k < c.size(); ++k) sum += 2.0 * static_cast<double>(k * k) * std::abs(c[k]);
      return sum;
    }
    case Scaling::Kind::sine:
      return std::abs(c[1] * c[2]);
    case Scaling::Kind::exponential:
      return std::abs(c[0] * c[1]) * std::max(1.0, math::exp(c[1]));
  }
  return 0.0;
}

Interval scaling_range(const Scaling& scaling, Interval over) {
  const bool is_monotone =
      scaling.kind == Scaling::Kind::exponential || (scaling.kind == Scaling::Kind::chebyshev && scaling.c.size() <= 2);
  if (is_monotone) {
    const double a = scaling_at(scaling, over.low);
    const double b = scaling_at(scaling, over.high);
    return {std::min(a, b), std::max(a, b)};
  }
  const double middle = scaling_at(scaling, over.middle());
  const double swing = 0.5 * over.width() * lipschitz_bound(scaling);
  const double sup = sup_bound(scaling);
  return common({-sup, sup}, {middle - swing, middle + swing});
}

}  // namespace burin::curves::fractal_interpolation
