#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/curves/de_rham.hpp>
#include <burin/curves/subdivision/convergence.hpp>

#include "naive_schemes.hpp"
#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// Closed forms of curves.md C, and its vectors.
namespace burin::curves {
namespace {

using namespace naive;
using nlohmann::json;
using testing::draw_points;
using testing::json_points;

json base_of(const Points& points, bool closed) {
  return {{"points", json_points(points)}, {"closed", closed}};
}

Points drawn(const Points& base, bool closed, double t, int levels, json more = json::object()) {
  more["base"] = base_of(base, closed);
  more["t"] = t;
  more["levels"] = levels;
  return draw_points("de-rham", more);
}

void expect_same(const Points& actual, const Points& expected, const std::string& what) {
  ASSERT_EQ(actual.size(), expected.size()) << what;
  const double tolerance = 1e-12 * size_of(expected);
  for (std::size_t i = 0; i < actual.size(); ++i) {
    ASSERT_LE(distance(actual[i], expected[i]), tolerance) << what << " point " << i;
  }
}

double random_t(std::uint64_t seed) {
  return -0.5 + 2.0 * uniform(seed, 9);
}

const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(DeRham, TheReferenceVectors) {
  for (const json& vector : testing::reference("curves.json")["C_de_rham"]) {
    json params = {{"base", {{"points", vector["start"]}, {"closed", vector["closed"]}}},
                   {"t", vector["t"]},
                   {"order", vector["order"]},
                   {"normalize", vector["name"] == "pentagon normalised"}};
    SCOPED_TRACE(params.dump());
    for (std::size_t level = 1; level <= vector["levels"].size(); ++level) {
      params["levels"] = level;
      testing::expect_points(draw_points("de-rham", params), vector["levels"][level - 1]);
    }
    params["levels"] = vector["high_level"];
    testing::expect_summary(draw_points("de-rham", params), vector["closed"], vector["high"]);
  }
}

TEST(DeRham, IsTheSchemeLevelByLevel) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Points base = random_points(seed, 2 + seed % 6);
    const double t = random_t(seed);
    const int levels = static_cast<int>(seed % 11);
    for (const bool closed : {false, true}) {
      for (const bool clamped : {false, true}) {
        Points expected = base;
        for (int level = 0; level < levels; ++level) expected = de_rham(expected, t, closed, clamped);
        expect_same(drawn(base, closed, t, levels, {{"ends", clamped ? "clamp" : "free"}}), expected,
                    "seed " + std::to_string(seed));
      }
    }
  }
}

TEST(DeRham, LambdaAndTheFarOrderAreOtherWaysToSayT) {
  const json base = {{"base", "square"}, {"levels", 5}};
  const auto with = [&](json params) {
    params.update(base);
    return draw_points("de-rham", params);
  };
  EXPECT_EQ(with({{"lambda", 0.5}}), with({{"t", 0.25}}));
  EXPECT_EQ(with({{"t", 0.75}, {"order", "far"}}), with({{"t", 0.25}}));
  EXPECT_EQ(with({{"lambda", -0.125}, {"order", "far"}}), with({{"t", 1 + 0.125 / 0.75}}));
  // As printed, the far point first: no corner cutting but a fractal, which is longer with every level.
  const auto length_at = [&](int levels) {
    Points points = draw_points("de-rham", {{"t", 0.25}, {"order", "far"}, {"base", "square"}, {"levels", levels}});
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += distance(points[i], points[(i + 1) % points.size()]);
    return sum;
  };
  EXPECT_GT(length_at(12), 1.25 * length_at(11));
}

TEST(DeRham, CountsOfClosedAndOpenBases) {
  for (const std::size_t n : {2U, 3U, 7U}) {
    for (int levels = 0; levels <= 6; ++levels) {
      const Points base = random_points(n, n);
      const auto power = std::size_t{1} << static_cast<unsigned>(levels);
      EXPECT_EQ(drawn(base, true, 0.3, levels).size(), n * power);
      EXPECT_EQ(drawn(base, false, 0.3, levels).size(), levels == 0 ? n : 2 + power * (n - 2));
    }
  }
}

TEST(DeRham, AClampedCurveKeepsItsEndsAndTouchesItsFirstAndLastEdge) {
  const Points base = random_points(5, 6);
  const Points curve = drawn(base, false, 0.2, 12, {{"ends", "clamp"}});
  EXPECT_EQ(curve.front(), base.front());
  EXPECT_EQ(curve.back(), base.back());
  const Vec2 first = curve[1] - curve[0];
  EXPECT_NEAR(cross(first, base[1] - base[0]) / (length(first) * distance(base[0], base[1])), 0.0, 1e-9);
}

TEST(DeRham, AreaLaw) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Points base = random_points(seed, 3 + seed % 5);
    const double t = random_t(seed);
    double b0 = 0.0;
    for (std::size_t i = 0; i < base.size(); ++i) {
      const auto at = [&](std::size_t k) { return base[(i + k) % base.size()]; };
      b0 += 0.5 * cross(at(1) - at(0), at(2) - at(1));
    }
    const double q = 2 * t * (1 - 2 * t);
    double sum = 0.0;
    double power = 1.0;
    for (int levels = 0; levels <= 8; ++levels) {
      const Points curve = drawn(base, true, t, levels);
      const double size = size_of(curve) * size_of(curve) * static_cast<double>(curve.size());
      EXPECT_NEAR(area_of(curve), area_of(base) - t * t * b0 * sum, 1e-13 * size) << seed << " level " << levels;
      sum += power;
      power *= q;
    }
  }
  EXPECT_NEAR(area_of(drawn(square, true, 0.25, 14)), 5.0 / 6, 1e-7);
  EXPECT_NEAR(area_of(drawn(square, true, 1.0 / 3, 14)), 5.0 / 7, 1e-7);
  EXPECT_NEAR(area_of(drawn(square, true, 0.1, 14)), 0.976190476190, 1e-7);
}

TEST(DeRham, ChaikinIsTheQuadraticBSpline) {
  const Points base = random_points(3, 7);
  constexpr int levels = 5;
  constexpr std::size_t per_corner = 32;
  const Points curve = drawn(base, true, 0.25, levels);
  for (std::size_t i = 0; i < base.size(); ++i) {
    const Vec2 before = base[(i + base.size() - 1) % base.size()];
    const Vec2 after = base[(i + 1) % base.size()];
    for (std::size_t j = 0; j < per_corner; ++j) {
      // The curve begins with the last point of the first corner.
      const std::size_t k = i * per_corner + j + curve.size() - (per_corner - 1);
      // The midpoint of an edge of any level is a point of the limit.
      const Vec2 midpoint = 0.5 * (curve[(k - 1) % curve.size()] + curve[k % curve.size()]);
      const double s = static_cast<double>(j) / per_corner;
      const Vec2 spline = 0.5 * (1 - s) * (1 - s) * before + (0.5 + s * (1 - s)) * base[i] + 0.5 * s * s * after;
      EXPECT_LE(distance(midpoint, spline), 1e-14 * 3);
    }
    // At the middle of a corner: (1, 6, 1)/8.
    const Vec2 value = 0.125 * (before + 6 * base[i] + after);
    const std::size_t middle = (i * per_corner + per_corner / 2 + curve.size() - (per_corner - 1)) % curve.size();
    EXPECT_LE(distance(0.5 * (curve[middle - 1] + curve[middle]), value), 1e-14 * 3);
  }
}

TEST(DeRham, MidpointsStayOnTheCurve) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Points base = random_points(seed, 5);
    const double t = random_t(seed);
    const Points curve = drawn(base, true, t, 1);
    for (std::size_t i = 0; i < base.size(); ++i) {
      const Vec2 a = base[i];
      const Vec2 b = base[(i + 1) % base.size()];
      const Vec2 c = base[(i + 2) % base.size()];
      const auto midpoint = [&](std::size_t k) {
        return 0.5 * (curve[k % curve.size()] + curve[(k + 1) % curve.size()]);
      };
      EXPECT_LE(distance(midpoint(2 * i), 0.5 * (a + b)), 1e-13);
      EXPECT_LE(distance(midpoint(2 * i + 1), 0.5 * t * a + (1 - t) * b + 0.5 * t * c), 1e-13);
    }
  }
}

TEST(DeRham, AffineMapsOfTheBaseCarryTheCurve) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Points base = random_points(seed, 5);
    const Affine2 map = random_affine(seed);
    const bool closed = seed % 2 == 0;
    expect_same(drawn(mapped(map, base), closed, random_t(seed), 6),
                mapped(map, drawn(base, closed, random_t(seed), 6)), "seed " + std::to_string(seed));
  }
}

TEST(DeRham, TheReversedBaseGivesTheReversedCurve) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Points base = random_points(seed, 5);
    const double t = random_t(seed);
    const json ends = {{"ends", seed % 2 == 0 ? "free" : "clamp"}, {"order", seed % 3 == 0 ? "far" : "near"}};
    expect_same(drawn(reversed(base), false, t, 6, ends), reversed(drawn(base, false, t, 6, ends)), "open");
    // Closed, the first edge of the one is the last of the other.
    Points from_first = reversed(base);
    std::rotate(from_first.begin(), from_first.end() - 1, from_first.end());
    Points other = reversed(drawn(base, true, t, 6, ends));
    // Every level starts an edge later, and has twice the points.
    std::rotate(other.begin(), other.begin() + 62, other.end());
    expect_same(drawn(from_first, true, t, 6, ends), other, "closed");
  }
}

TEST(DeRham, ConvergesJustForTBetween0And1) {
  const Points base = random_points(4, 5);
  for (const double t : {0.05, 0.2, 0.25, 0.3, 1.0 / 3, 0.45, 0.5, 0.6, 0.75, 0.9}) {
    const double radius = de_rham_spectral_radius(t);
    EXPECT_LT(radius, 1.0) << t;
    // Longest edges shrink like powers of the radius, up to a factor.
    const double long_before = longest_edge(drawn(base, true, t, 4), true);
    EXPECT_LE(longest_edge(drawn(base, true, t, 12), true), 3.0 * long_before * std::pow(radius, 8)) << t;
  }
  for (const double t : {-0.5, -0.1, 0.0, 1.0, 1.1, 1.5}) {
    const double factor = std::abs(1 - 2 * t);
    EXPECT_GE(de_rham_spectral_radius(t), 1.0) << t;
    EXPECT_GE(longest_edge(drawn(base, true, t, 9), true), (1 - 1e-12) * std::pow(factor, 9) * longest_edge(base, true))
        << t;
  }
}

TEST(DeRham, TheSpectralRadiusLiesBetweenItsBounds) {
  for (const double t : {-0.5, -0.2, 0.0, 0.1, 0.25, 0.3, 1.0 / 3, 0.4, 0.5, 0.6, 0.75, 0.9, 1.0, 1.2}) {
    const std::vector<double> differences{t, 1 - 2 * t, t};
    const double radius = de_rham_spectral_radius(t);
    EXPECT_LE(subdivision::spectral_radius_bound(differences, 10), radius + 1e-9) << t;
    EXPECT_GE(subdivision::spectral_radius_bound(differences, 10), radius - 2e-2) << t;
    for (const double steps : {1.0, 6.0, 12.0}) {
      const double norm = subdivision::norms_of_powers(differences, static_cast<int>(steps)).back();
      EXPECT_GE(std::pow(norm, 1 / steps), radius - 1e-9) << t;
    }
  }
}

TEST(DeRham, CornersAtMidpointsOfEdges) {
  // curves.md C: half the corner of a right angle with equal legs is atan((3t-1)/t) for 1/3 < t < 1/2, and none below.
  for (const double t : {0.2, 0.25, 0.4, 0.45}) {
    const Points curve = drawn(square, true, t, 14);
    std::size_t k = 0;
    while (distance(0.5 * (curve[k] + curve[k + 1]), {0.5, 0}) > 1e-6) ++k;
    const Vec2 along = curve[k + 1] - curve[k];
    const Vec2 next = curve[k + 2] - curve[k + 1];
    EXPECT_NEAR(std::atan2(cross(along, next), dot(along, next)), t > 1.0 / 3 ? std::atan((3 * t - 1) / t) : 0.0, 5e-3);
  }
}

TEST(DeRham, ConvexPolygonsStayConvexUpToOneHalf) {
  for (const double t : {0.1, 0.25, 0.4, 0.49}) {
    const Points curve = drawn(square, true, t, 8);
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const auto at = [&](std::size_t k) { return curve[(i + k) % curve.size()]; };
      EXPECT_GE(cross(at(1) - at(0), at(2) - at(1)), -1e-16);
    }
  }
  EXPECT_EQ(drawn(square, true, 0.5, 1),
            (Points{{0.5, 0}, {0.5, 0}, {1, 0.5}, {1, 0.5}, {0.5, 1}, {0.5, 1}, {0, 0.5}, {0, 0.5}}));
}

TEST(DeRham, NormalizedItNeitherGrowsNorVanishes) {
  for (const double t : {-0.5, -0.2, 1.3, 5.0}) {
    const Points base = random_points(7, 5);
    Vec2 centre;
    for (const Vec2 p : base) centre = centre + 0.2 * p;
    double farthest = 0.0;
    for (const Vec2 p : base) farthest = std::max(farthest, distance(p, centre));
    for (const int levels : {1, 5, 10}) {
      const Points curve = drawn(base, true, t, levels, {{"normalize", true}});
      for (const Vec2 p : curve) ASSERT_LE(distance(p, centre), farthest * (1 + 1e-12));
      EXPECT_GE(longest_edge(curve, true), longest_edge(base, true) * (1 - 1e-12));
      // The same picture, smaller.
      const Points plain = drawn(base, true, t, levels);
      const double shrunk = std::pow(std::abs(1 - 2 * t), -levels);
      for (std::size_t i = 0; i < curve.size(); i += 7) {
        ASSERT_LE(distance(curve[i] - centre, shrunk * (plain[i] - centre)), 1e-10 * farthest);
      }
    }
  }
  // Between 0 and 1 there is nothing to normalize.
  EXPECT_EQ(drawn(square, true, 0.3, 4, {{"normalize", true}}), drawn(square, true, 0.3, 4));
}

TEST(DeRham, ContradictionsAreReported) {
  const auto problems = [](const char* params) { return testing::read_params("de-rham", params).problems; };
  EXPECT_EQ(problems(R"({"t": 0.3, "lambda": 1})").size(), 1U);
  EXPECT_EQ(problems(R"({"lambda": -0.5})").size(), 1U);
  EXPECT_EQ(problems(R"({"ends": "linear"})").size(), 1U);
  EXPECT_TRUE(problems(R"({"lambda": -0.6, "order": "far"})").empty());
}

}  // namespace
}  // namespace burin::curves
