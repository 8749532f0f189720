#include <array>
#include <functional>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/curves/fractal_interpolation/error_bounds.hpp>

#include "made_data.hpp"

/// Reference interpolation 3, 4 and 9, at random parameters too.
namespace burin::curves::fractal_interpolation {
namespace {

constexpr std::uint64_t cases = 40;

std::vector<double> nodes(std::size_t intervals, double low = 0.0, double high = 1.0) {
  std::vector<double> x;
  for (std::size_t i = 0; i <= intervals; ++i) {
    x.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(intervals));
  }
  return x;
}

std::vector<double> values_of(const std::function<double(double)>& g, const std::vector<double>& x) {
  std::vector<double> values;
  for (const double each : x) values.push_back(g(each));
  return values;
}

/// The largest |g - phi| at `count` places; phi good to `tolerance`.
double largest_error(const Interpolant& f, const std::function<double(double)>& g, int count = 400) {
  double error = 0.0;
  for (int k = 0; k <= count; ++k) {
    const double x = f.begin + f.length * (k + 0.37) / (count + 1.0);
    error = std::max(error, std::abs(g(x) - value_at(f, x)));
  }
  return error;
}

TEST(FractalInterpolation, PassesThroughTheNodesAndTheMapsJoin) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const InterpolationData data = random_data(seed, 0.95);
    const Interpolant f = make_interpolant(data);
    for (std::size_t i = 0; i < f.pieces.size(); ++i) {
      const GraphPoint left = mapped(f, f.pieces[i], node_point(f, 0));
      EXPECT_EQ(left.theta, f.pieces[i].start);
      EXPECT_EQ(left.y, data.values[i]);
      const GraphPoint right = mapped(f, f.pieces[i], node_point(f, f.pieces.size()));
      EXPECT_NEAR(right.theta, node_point(f, i + 1).theta, 1e-13);
      EXPECT_NEAR(right.y, data.values[i + 1], 1e-13);
    }
    for (std::size_t i = 0; i < data.x.size(); ++i) EXPECT_NEAR(value_at(f, data.x[i]), data.values[i], 1e-12);
  }
}

TEST(FractalInterpolation, SolvesItsFunctionalEquation) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const Interpolant f = make_interpolant(random_data(seed, 0.3));
    Draws draw(seed + 1000);
    for (int k = 0; k < 20; ++k) {
      const double theta = draw(0.0, 1.0);
      const Piece& piece = f.pieces[static_cast<std::size_t>(draw(0.0, static_cast<double>(f.pieces.size())))];
      const double source = value_at(f, f.begin + f.length * theta);
      const GraphPoint image = mapped(f, piece, {theta, source});
      // phi at a place rounded by 1e-16 may differ by the place's error to the power tau.
      EXPECT_NEAR(value_at(f, f.begin + f.length * image.theta), image.y, 1e-8);
    }
  }
}

TEST(FractalInterpolation, WithoutScalingIsTheClassicalSplineAndHermitesAtThree) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    InterpolationData data = with_scaling(random_data(seed, 0.5), constant_scaling(0.0));
    const Interpolant rational = make_interpolant(data);
    data = with_shape(data, {3.0, 3.0});
    const Interpolant hermite = make_interpolant(data);
    Draws draw(seed + 2000);
    for (int k = 0; k < 20; ++k) {
      const double x = draw(data.x.front(), data.x.back());
      EXPECT_EQ(value_at(rational, x), classical_value(rational, x));
      const std::size_t i = piece_at(hermite, (x - hermite.begin) / hermite.length);
      const double h = data.x[i + 1] - data.x[i];
      const double t = (x - data.x[i]) / h;
      const double expected =
          (1 + 2 * t) * (1 - t) * (1 - t) * data.values[i] + t * t * (3 - 2 * t) * data.values[i + 1] +
          h * t * (1 - t) * (1 - t) * data.derivatives[i] - h * t * t * (1 - t) * data.derivatives[i + 1];
      EXPECT_NEAR(value_at(hermite, x), expected, 1e-12);
    }
  }
}

TEST(FractalInterpolation, IsLinearInItsDataAndKeepsToShiftedAndStretchedX) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const InterpolationData data = random_data(seed, 0.8);
    InterpolationData scaled = data;
    InterpolationData shifted = data;
    for (std::size_t i = 0; i < data.x.size(); ++i) {
      scaled.values[i] = -2.5 * data.values[i] + 7.0;
      scaled.derivatives[i] = -2.5 * data.derivatives[i];
      shifted.x[i] = 4.0 * data.x[i] - 3.0;
      shifted.derivatives[i] = data.derivatives[i] / 4.0;
    }
    const std::vector<Vec2> points = level_set(make_interpolant(data), 3);
    const std::vector<Vec2> of_scaled = level_set(make_interpolant(scaled), 3);
    const std::vector<Vec2> of_shifted = level_set(make_interpolant(shifted), 3);
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_NEAR(of_scaled[k].y, -2.5 * points[k].y + 7.0, 1e-11);
      EXPECT_NEAR(of_shifted[k].y, points[k].y, 1e-11);
      EXPECT_NEAR(of_shifted[k].x, 4.0 * points[k].x - 3.0, 1e-12 * 40.0);
    }
  }
}

TEST(FractalInterpolation, SumOfDataGivesSumOfFunctions) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const InterpolationData data = random_data(seed, 0.8);
    InterpolationData other = data;
    InterpolationData sum = data;
    Draws draw(seed + 3000);
    for (std::size_t i = 0; i < data.x.size(); ++i) {
      other.values[i] = draw(-1.0, 1.0);
      other.derivatives[i] = draw(-1.0, 1.0);
      sum.values[i] += other.values[i];
      sum.derivatives[i] += other.derivatives[i];
    }
    const std::vector<Vec2> a = level_set(make_interpolant(data), 3);
    const std::vector<Vec2> b = level_set(make_interpolant(other), 3);
    const std::vector<Vec2> c = level_set(make_interpolant(sum), 3);
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(c[k].y, a[k].y + b[k].y, 1e-11);
  }
}

TEST(FractalInterpolation, ReproducesStraightLinesWhenAlphaEqualsBeta) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    InterpolationData data = random_data(seed, 0.9);
    for (std::size_t i = 0; i < data.x.size(); ++i) {
      data.values[i] = 2.0 - 3.0 * data.x[i];
      data.derivatives[i] = -3.0;
    }
    for (Shape& shape : data.shapes) shape.beta = shape.alpha;
    for (const Vec2 p : level_set(make_interpolant(data), 3)) EXPECT_NEAR(p.y, 2.0 - 3.0 * p.x, 1e-12 * 20.0);
    // With alpha != beta it does not: the paper's second-order error is a first-order one.
    data.shapes[0] = {1.0, 0.2};
    double error = 0.0;
    for (const Vec2 p : level_set(make_interpolant(data), 3)) error = std::max(error, std::abs(p.y - 2.0 + 3.0 * p.x));
    EXPECT_GT(error, 1e-4);
  }
}

TEST(FractalInterpolation, ReproducesQuadraticsAtThreeWithMeanDerivatives) {
  const auto parabola = [](double x) { return 1.0 - 2.0 * x + 3.0 * x * x; };
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const InterpolationData random = random_data(seed, 0.9);
    InterpolationData data = plain_data(random.x, values_of(parabola, random.x));
    data.scalings = random.scalings;
    for (const Vec2 p : level_set(make_interpolant(data), 3)) EXPECT_NEAR(p.y, parabola(p.x), 1e-12 * 200.0);
  }
}

TEST(FractalInterpolation, InfiniteShapeMakesTakagisFunction) {
  InterpolationData data{{0.0, 0.5, 1.0}, {0.0, 0.5, 0.0}, {0.0, 0.0, 0.0}, {}, {}};
  data.shapes.assign(2, {1e12, 1e12});
  data.scalings.assign(2, constant_scaling(0.5));
  const Interpolant f = make_interpolant(data);
  const auto takagi = [](double x) {
    double sum = 0.0;
    double scale = 1.0;
    for (int k = 0; k < 50; ++k) {
      sum += std::abs(x / scale - std::nearbyint(x / scale)) * scale;
      scale *= 0.5;
    }
    return sum;
  };
  for (const Vec2 p : level_set(f, 9)) EXPECT_NEAR(p.y, takagi(p.x), 1e-9);
  EXPECT_NEAR(value_at(f, 1.0 / 3.0), 2.0 / 3.0, 1e-9);
}

TEST(FractalInterpolation, IsSmoothWhereScalingStaysBelowTheIntervals) {
  // s_i in C1 and S_i < a_i: phi is C1 and phi'(x_i) = d_i. Quotients come near d_i like step^(log(S/a) / log a), which
  // is slow for S close to a.
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    InterpolationData data = random_data(seed, 1.0);
    const double length = data.x.back() - data.x.front();
    for (std::size_t i = 0; i < data.scalings.size(); ++i) {
      const double a = (data.x[i + 1] - data.x[i]) / length;
      data.scalings[i] = {Scaling::Kind::chebyshev, {0.05 * a, -0.05 * a}};
    }
    const Interpolant f = make_interpolant(data);
    for (std::size_t i = 0; i < data.x.size(); ++i) {
      const double step = 1e-6;
      if (i + 1 < data.x.size()) {
        EXPECT_NEAR((value_at(f, data.x[i] + step) - data.values[i]) / step, data.derivatives[i], 2e-2);
      }
      if (i > 0) {
        EXPECT_NEAR((data.values[i] - value_at(f, data.x[i] - step)) / step, data.derivatives[i], 2e-2);
      }
    }
  }
}

TEST(FractalInterpolation, HoelderExponentIsThatOfScalingAndInterval) {
  // s = 1/2 on four equal intervals: tau = log(1/2)/log(1/4) = 1/2, so that the oscillation halves with each level.
  const InterpolationData data = with_scaling(plain_data(nodes(4), {0.0, 0.8, 0.2, 1.0, 0.3}), constant_scaling(0.5));
  const Interpolant f = make_interpolant(data);
  std::array<double, 4> swing{};
  const std::vector<Vec2> points = level_set(f, 6);
  for (std::size_t m = 0; m < swing.size(); ++m) {
    const std::size_t cell = std::size_t{1} << (2 * (6 - m));
    for (std::size_t k = 0; k + cell < points.size(); k += cell) {
      const auto [low, high] = std::minmax_element(points.begin() + static_cast<std::ptrdiff_t>(k),
                                                   points.begin() + static_cast<std::ptrdiff_t>(k + cell + 1),
                                                   [](Vec2 a, Vec2 b) { return a.y < b.y; });
      swing[m] = std::max(swing[m], high->y - low->y);
    }
  }
  EXPECT_NEAR(swing[3] / swing[2], 0.5, 0.05);
}

/// log2 of how the error falls from n to 2n intervals.
double order(const std::function<double(std::size_t)>& error, std::size_t n) {
  return math::log2(error(n) / error(2 * n));
}

double sine(double x) {
  return math::sin(3.0 * x + 0.5);
}

InterpolationData sine_data(std::size_t n, bool exact) {
  const std::vector<double> x = nodes(n);
  InterpolationData data = plain_data(x, values_of(&sine, x));
  if (exact) {
    for (std::size_t i = 0; i <= n; ++i) data.derivatives[i] = 3.0 * math::cos(3.0 * x[i] + 0.5);
  }
  return data;
}

TEST(FractalInterpolation, ClassicalSplineConvergesAtTheOrdersOfTheReference) {
  struct Case {
    bool exact;
    Shape shape;
    double order;
  };
  for (const Case& each : {Case{true, {3.0, 3.0}, 4.0}, Case{false, {3.0, 3.0}, 3.0}, Case{true, {1.0, 1.0}, 2.0},
                           Case{true, {1.0, 0.8}, 1.0}}) {
    const auto error = [&](std::size_t n) {
      return largest_error(make_interpolant(with_shape(sine_data(n, each.exact), each.shape)), &sine, 4000);
    };
    EXPECT_NEAR(order(error, 32), each.order, 0.15) << each.shape.alpha << ' ' << each.exact;
  }
}

TEST(FractalInterpolation, FractalOneConvergesAsItsScalingFalls) {
  const auto error_with = [](const std::function<double(double)>& scaling) {
    return [&scaling](std::size_t n) {
      const InterpolationData data =
          with_scaling(sine_data(n, true), constant_scaling(scaling(static_cast<double>(n))));
      return largest_error(make_interpolant(data), &sine, 4000);
    };
  };
  // At fixed s the error does not fall: the paper's Theorem 2 is no convergence.
  const auto fixed = [](double) { return 0.3; };
  EXPECT_NEAR(order(error_with(fixed), 16), 0.0, 0.05);
  const auto first = [](double n) { return 0.5 / n; };
  EXPECT_NEAR(order(error_with(first), 16), 1.0, 0.1);
  const auto second = [](double n) { return 0.5 / (n * n); };
  EXPECT_NEAR(order(error_with(second), 16), 2.0, 0.1);
  const auto fourth = [](double n) { return 0.5 / (n * n * n * n); };
  EXPECT_NEAR(order(error_with(fourth), 16), 4.0, 0.2);
}

TEST(FractalInterpolation, SplineDerivativesMakeTheCubicSpline) {
  // A cubic is its own spline, whatever the nodes.
  const auto cubic = [](double x) { return x * (x - 1.0) * (x + 2.0) + 0.5; };
  const std::vector<double> x{-1.0, -0.4, 0.1, 0.9, 1.0, 2.5};
  const std::vector<double> d = spline_derivatives(x, values_of(cubic, x), Ends::open);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(d[i], 3.0 * x[i] * x[i] + 2.0 * x[i] - 2.0, 1e-12);
  // Elsewhere: the second derivative does not jump at inner nodes; a closed one has no seam.
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    InterpolationData data = random_data(seed, 0.5);
    if (data.x.size() < 4) continue;
    for (const Ends ends : {Ends::open, Ends::periodic}) {
      if (ends == Ends::periodic) data.values.back() = data.values.front();
      data.derivatives = spline_derivatives(data.x, data.values, ends);
      const std::size_t n = data.shapes.size();
      const auto second = [&](std::size_t i, bool at_right) {
        const double h = data.x[i + 1] - data.x[i];
        const double slope = (data.values[i + 1] - data.values[i]) / h;
        return at_right ? (2.0 * data.derivatives[i] + 4.0 * data.derivatives[i + 1] - 6.0 * slope) / h
                        : (6.0 * slope - 4.0 * data.derivatives[i] - 2.0 * data.derivatives[i + 1]) / h;
      };
      for (std::size_t i = 1; i < n; ++i) EXPECT_NEAR(second(i - 1, true), second(i, false), 1e-8);
      if (ends == Ends::periodic) {
        EXPECT_EQ(data.derivatives.front(), data.derivatives.back());
        EXPECT_NEAR(second(n - 1, true), second(0, false), 1e-8);
      } else {
        const auto third = [&](std::size_t i) {
          return (second(i, true) - second(i, false)) / (data.x[i + 1] - data.x[i]);
        };
        EXPECT_NEAR(third(0), third(1), 1e-6 * std::max(1.0, std::abs(third(0))));
        EXPECT_NEAR(third(n - 2), third(n - 1), 1e-6 * std::max(1.0, std::abs(third(n - 1))));
      }
    }
  }
}

TEST(FractalInterpolation, ChaosGameStaysOnTheGraph) {
  const Interpolant f = make_interpolant(random_data(7, 0.3));
  double mean = 0.0;
  for (const Vec2 p : chaos_points(f, 4000, 5)) {
    EXPECT_NEAR(p.y, value_at(f, p.x), 1e-8);
    mean += (p.x - f.begin) / f.length / 4000.0;
  }
  EXPECT_NEAR(mean, 0.5, 0.03);
}

TEST(FractalInterpolation, BadDataIsNamed) {
  const InterpolationData good = random_data(3, 0.9);
  EXPECT_EQ(trouble_with(good).of, "");
  const auto trouble = [&](const std::function<void(InterpolationData&)>& spoil) {
    InterpolationData data = good;
    spoil(data);
    return trouble_with(data).text;
  };
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  has(trouble([](auto& d) { d.scalings[1] = {Scaling::Kind::chebyshev, {0.7, -0.3}}; }), "interval 2 may reach 1 ");
  has(trouble([](auto& d) { d.scalings[0] = {Scaling::Kind::sine, {0.5, 0.6, 1.0, 0.0}}; }), "below 1");
  has(trouble([](auto& d) { d.scalings[0] = {Scaling::Kind::exponential, {0.5, 1.0}}; }), "interval 1");
  has(trouble([](auto& d) { d.scalings[0].c[0] = std::nan(""); }), "not finite");
  has(trouble([](auto& d) { d.shapes[1].alpha = -0.1; }), "'alpha' of interval 2 is -0.1; it must be 0 or more");
  has(trouble([](auto& d) { d.shapes[0].beta = INFINITY; }), "'beta' of interval 1 is not finite");
  has(trouble([](auto& d) { d.x[1] = d.x[0]; }), "must increase");
  has(trouble([](auto& d) { d.values[1] = std::nan(""); }), "point 2 is not finite");
  has(trouble([](auto& d) { d.derivatives[0] = INFINITY; }), "derivative at point 1");
}

/// Example 1: sin at five nodes with the paper's alpha and beta; its Tables 2 and 3 are lost, so the four scaling sets
/// and the perturbation are the reference's.
TEST(FractalInterpolation, ExampleOneHasTheErrorsOfTheReference) {
  using Kind = Scaling::Kind;
  const std::vector<double> x{0.1, 0.2, 0.3, 0.4, 0.5};
  const std::vector<double> values{0.0998, 0.1987, 0.2955, 0.3894, 0.4794};
  const std::vector<double> moved_by{0.002, -0.001, 0.0015, -0.002, 0.001};
  struct Case {
    std::vector<Scaling> scalings;
    std::array<double, 4> expected;  ///< f - phi from, to; phi - phi* from, to
  };
  const Scaling s1 = constant_scaling(0.02);
  const std::vector<Case> table{{{s1, s1, s1, s1}, {-1.59e-3, 2.17e-3, -2.00e-3, 3.24e-3}},
                                {{{Kind::chebyshev, {.02, .02}},
                                  {Kind::chebyshev, {.03, -.01}},
                                  {Kind::chebyshev, {-.02, .01}},
                                  {Kind::chebyshev, {.01, .03}}},
                                 {-1.81e-3, 2.17e-3, -2.00e-3, 3.53e-3}},
                                {{{Kind::sine, {0, .04, 6, 0}},
                                  {Kind::sine, {.01, .03, 9, 1}},
                                  {Kind::sine, {0, .05, 3, 2}},
                                  {Kind::sine, {0, .02, 12, 0}}},
                                 {-2.21e-3, 2.23e-3, -2.00e-3, 4.03e-3}},
                                {{{Kind::exponential, {.05, -1}},
                                  {Kind::sine, {0, .05, 6, 0}},
                                  {Kind::chebyshev, {.02, .03}},
                                  {Kind::chebyshev, {-.04}}},
                                 {-2.80e-3, 2.18e-3, -2.00e-3, 4.62e-3}}};
  for (const Case& each : table) {
    InterpolationData data = plain_data(x, values);
    data.shapes = {{1.0, 0.8}, {1.0, 0.8}, {0.002, 0.004}, {0.01, 0.04}};
    data.scalings = each.scalings;
    std::vector<double> other = values;
    for (std::size_t i = 0; i < other.size(); ++i) other[i] += moved_by[i];
    InterpolationData moved = plain_data(x, other);
    moved.shapes = data.shapes;
    moved.scalings = data.scalings;
    const std::vector<Vec2> phi = level_set(make_interpolant(data), 4);
    const std::vector<Vec2> star = level_set(make_interpolant(moved), 4);
    std::array<double, 4> range{};
    for (std::size_t k = 0; k < phi.size(); ++k) {
      const double error = math::sin(phi[k].x) - phi[k].y;
      const double change = phi[k].y - star[k].y;
      range = {std::min(range[0], error), std::max(range[1], error), std::min(range[2], change),
               std::max(range[3], change)};
    }
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(range[k], each.expected[k], 5.5e-6) << k;
  }
}

}  // namespace
}  // namespace burin::curves::fractal_interpolation
