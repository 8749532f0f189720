#include <gtest/gtest.h>

#include <burin/curves/fractal_interpolation/error_bounds.hpp>

#include "made_data.hpp"

/// What is called a bound is one, at random parameters; and none is absurdly loose.
namespace burin::curves::fractal_interpolation {
namespace {

constexpr std::uint64_t cases = 40;

TEST(FractalBounds, WeightsSumToOneAndStayInTheirRanges) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Draws draw(seed);
    const Shape shape{seed % 5 == 0 ? 0.0 : draw(0.0, 20.0), seed % 7 == 0 ? 1e12 : draw(0.0, 20.0)};
    const double theta = draw(0.0, 1.0);
    const Weights w = weights_at(theta, shape);
    EXPECT_NEAR(w.left + w.right, 1.0, 1e-15);
    EXPECT_GE(std::min({w.left, w.right, w.left_slope}), 0.0);
    EXPECT_LE(w.right_slope, 0.0);
    EXPECT_LE(w.left_slope - w.right_slope, (1.0 + 1e-14) / (1.0 + std::min(shape.alpha, shape.beta)));
  }
}

TEST(FractalBounds, SlopesAndRangesOfTheRationalCubicHold) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Draws draw(seed);
    const EndData ends{draw(-1.0, 1.0), draw(-1.0, 1.0), draw(-9.0, 9.0), draw(-9.0, 9.0)};
    const Shape shape{seed % 5 == 0 ? 0.0 : draw(0.0, 9.0), seed % 7 == 0 ? 1e9 : draw(0.0, 9.0)};
    const double a = draw(0.0, 1.0);
    const double b = std::min(1.0, a + draw(0.0, 0.2));
    const Interval range = value_range(ends, shape, {a, b});
    const double bound = slope_bound(ends, shape);
    double steepest = 0.0;
    Interval found{1e300, -1e300};
    const auto look_at = [&](double theta) {
      steepest = std::max(steepest, std::abs(combine(weight_slopes_at(theta, shape), ends)));
    };
    // Large shape parameters are steep close to an end only.
    for (double theta = 0.5; theta > 1e-9; theta *= 0.97) {
      look_at(theta);
      look_at(1.0 - theta);
    }
    for (int k = 0; k <= 1000; ++k) {
      look_at(k / 1000.0);
      const double y = combine(weights_at(a + (b - a) * k / 1000.0, shape), ends);
      found = hull(found, {y, y});
    }
    EXPECT_LE(steepest, bound * (1.0 + 1e-12));
    EXPECT_GE(steepest, 0.9 * bound) << shape.alpha << ' ' << shape.beta;
    EXPECT_LE(range.low, found.low + 1e-12);
    EXPECT_GE(range.high, found.high - 1e-12);
  }
}

TEST(FractalBounds, ScalingsStayWithinTheirBounds) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    for (const Scaling& scaling : random_data(seed, 0.9).scalings) {
      Draws draw(seed);
      const double a = draw(0.0, 0.9);
      const Interval range = scaling_range(scaling, {a, a + 0.1});
      for (int k = 0; k <= 100; ++k) {
        const double theta = a + 0.001 * k;
        const double s = scaling_at(scaling, theta);
        EXPECT_LE(std::abs(s), sup_bound(scaling) + 1e-15);
        EXPECT_LE(std::abs(s - scaling_at(scaling, a)), lipschitz_bound(scaling) * 0.001 * k + 1e-15);
        EXPECT_GE(s, range.low - 1e-15);
        EXPECT_LE(s, range.high + 1e-15);
      }
    }
  }
}

TEST(FractalBounds, GapAndStabilityBoundsHold) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const InterpolationData data = random_data(seed, 0.8);
    const Interpolant f = make_interpolant(data);
    const double gap = gap_bound(f);
    std::vector<double> dv;
    std::vector<double> dd;
    InterpolationData moved = data;
    Draws draw(seed + 99);
    for (std::size_t i = 0; i < data.x.size(); ++i) {
      dv.push_back(draw(-0.1, 0.1));
      dd.push_back(draw(-0.1, 0.1));
      moved.values[i] += dv[i];
      moved.derivatives[i] += dd[i];
    }
    const double stable = stability_bound(f, dv, dd);
    const std::vector<Vec2> phi = level_set(f, 3);
    const std::vector<Vec2> star = level_set(make_interpolant(moved), 3);
    for (std::size_t k = 0; k < phi.size(); ++k) {
      EXPECT_LE(std::abs(phi[k].y - classical_value(f, phi[k].x)), gap);
      EXPECT_LE(std::abs(phi[k].y - star[k].y), stable);
    }
  }
}

TEST(FractalBounds, LevelBoundsHoldForThePolylines) {
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const Interpolant f = make_interpolant(random_data(seed, 0.6));
    const std::vector<double> bounds = level_bounds(f, 2);
    const std::vector<Vec2> fine = level_set(f, 4);
    for (std::size_t m = 0; m < bounds.size(); ++m) {
      const std::vector<Vec2> coarse = level_set(f, static_cast<int>(m));
      std::size_t segment = 0;
      for (const Vec2 p : fine) {
        while (segment + 2 < coarse.size() && coarse[segment + 1].x < p.x) ++segment;
        const Vec2 a = coarse[segment];
        const Vec2 b = coarse[segment + 1];
        EXPECT_LE(std::abs(p.y - lerp(a, b, (p.x - a.x) / (b.x - a.x)).y), bounds[m]);
      }
    }
  }
}

}  // namespace
}  // namespace burin::curves::fractal_interpolation
