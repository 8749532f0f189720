#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/curves/family.hpp>
#include <burin/curves/two_point/placed_points.hpp>
#include <burin/path/point_store.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"
#include "support/random_paths.hpp"

namespace burin::curves {
namespace {

using nlohmann::json;
using testing::draw_points;
using testing::record;
using testing::two_point;

std::vector<Vec2> curve(const std::string& motif, int levels, const std::string& more = "") {
  return draw_points(two_point(R"({"motif": ")" + motif + R"(", "levels": )" + std::to_string(levels) + more + "}"));
}

double polyline_length(const std::vector<Vec2>& points) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += distance(points[i], points[i + 1]);
  return sum;
}

double polygon_area(const std::vector<Vec2>& points) {
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) area += 0.5 * cross(points[i], points[(i + 1) % points.size()]);
  return area;
}

TEST(TwoPoint, PointsOfATableArePlacedByTheFormulaToTheBit) {
  test::Dice dice(21);
  const auto random_point = [&] { return Vec2{dice.between(-2.0, 2.0), dice.between(-2.0, 2.0)}; };
  for (std::size_t count = 0; count < 20; ++count) {
    std::vector<Vec2> table;
    while (table.size() < count) table.push_back(random_point());
    const Vec2 p = random_point();
    const Vec2 d = random_point();
    std::vector<Vec2> room(count + 1, Vec2{7.0, 7.0});
    two_point::place_points(table, p, d, room.data());
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(room[k], p + complex_product(table[k], d)) << k;
    EXPECT_EQ(room[count], (Vec2{7.0, 7.0}));
  }
}

TEST(TwoPoint, PointsInMemoryAreThoseOfTheDrawingToTheBit) {
  // Blocks of 1024, 1024, 729 and 324 edges, which end now here, now there in the spans of a drawing.
  for (const std::string motif : {"koch", "dragon", "terdragon", "quad18"}) {
    for (const std::string base : {"segment", "square"}) {
      for (int levels = 0; levels <= (motif == "quad18" ? 4 : 9); ++levels) {
        const TwoPointParams params = two_point(R"({"motif": ")" + motif + R"(", "base": ")" + base +
                                                R"(", "levels": )" + std::to_string(levels) + "}");
        const std::vector<Vec2> drawn = draw_points(params);
        for (const std::size_t start : {0U, 1U}) {
          std::vector<Vec2> memory(start + drawn.size());
          PointStore store{std::span(memory).subspan(start)};
          ASSERT_EQ(find_family("two-point")->draw(params, {}, store), Flow::go);
          EXPECT_TRUE(std::ranges::equal(store.stored(), drawn)) << motif << ' ' << base << ' ' << levels;
        }
      }
    }
  }
}

TEST(TwoPoint, LevelZeroIsTheBase) {
  EXPECT_EQ(curve("koch", 0), (std::vector<Vec2>{{0, 0}, {1, 0}}));
  EXPECT_EQ(curve("koch", 0, R"(, "base": "square")"), (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST(TwoPoint, CountsAndLengthsOfOneEdge) {
  // curves.md A.5: the length grows by the sum of the ratios.
  const struct {
    const char* motif;
    double k;
    double factor;
  } rows[] = {{"koch", 4, 4.0 / 3},
              {"minkowski", 8, 2},
              {"levy", 2, std::sqrt(2.0)},
              {"dragon", 2, std::sqrt(2.0)},
              {"terdragon", 3, std::sqrt(3.0)},
              {"sierpinski", 3, 1.5},
              {"quad5", 5, 5.0 / 3},
              {"quad18", 18, 3},
              {"quad32", 32, 4},
              {"r5dragon", 5, std::sqrt(5.0)},
              {"gosper", 7, std::sqrt(7.0)},
              {"peano9", 9, 3},
              {"hilbert4", 4, 2}};
  for (const auto& row : rows) {
    for (int level = 0; std::pow(row.k, level) <= 40000; ++level) {
      const std::vector<Vec2> points = curve(row.motif, level);
      EXPECT_EQ(static_cast<double>(points.size()), std::pow(row.k, level) + 1) << row.motif;
      const double length = std::pow(row.factor, level);
      EXPECT_NEAR(polyline_length(points), length, 1e-12 * length) << row.motif;
    }
  }
}

TEST(TwoPoint, SnowflakeAndIslandHaveTheirAreas) {
  for (int level = 0; level <= 6; ++level) {
    const std::vector<Vec2> flake = curve("koch", level, R"(, "base": "triangle")");
    EXPECT_EQ(flake.size(), 3U << (2U * static_cast<unsigned>(level)));
    const double area = std::sqrt(3.0) / 4 + std::sqrt(3.0) / 12 * (1 - std::pow(4.0 / 9, level)) / (5.0 / 9);
    EXPECT_NEAR(polygon_area(flake), area, 1e-12);
  }
  for (int level = 0; level <= 4; ++level) {
    EXPECT_NEAR(polygon_area(curve("minkowski", level, R"(, "base": "square")")), 1.0, 1e-12);
  }
  // The twindragon: the dragon on the 2-gon P -> Q -> P.
  EXPECT_NEAR(std::abs(polygon_area(curve("dragon", 12, R"(, "base": {"points": [[0,0],[1,0]], "closed": true})"))),
              0.5, 1e-12);
}

/// The turn at vertex n in degrees, + left.
double turn_degrees(const std::vector<Vec2>& p, std::size_t n) {
  const Vec2 in = p[n] - p[n - 1];
  const Vec2 out = p[n + 1] - p[n];
  return std::atan2(cross(in, out), dot(in, out)) * 180 / M_PI;
}

/// n = k^z q with k not dividing q.
struct Valuation {
  int z = 0;
  std::size_t q = 0;
};
Valuation valuation(std::size_t n, std::size_t k) {
  Valuation v{0, n};
  while (v.q % k == 0) {
    v.q /= k;
    ++v.z;
  }
  return v;
}

TEST(TwoPoint, TurningSequences) {
  // curves.md A.5.
  const auto check = [](const char* motif, int levels, std::size_t k, auto expected) {
    const std::vector<Vec2> points = curve(motif, levels);
    for (std::size_t n = 1; n + 1 < points.size(); ++n) {
      ASSERT_NEAR(turn_degrees(points, n), expected(n, valuation(n, k)), 1e-6) << motif << " vertex " << n;
    }
  };
  check("koch", 5, 4, [](std::size_t, Valuation v) { return v.q % 4 == 2 ? 120.0 : -60.0; });
  check("minkowski", 3, 8,
        [](std::size_t, Valuation v) { return std::array<double, 8>{0, -90, 90, 90, 0, -90, -90, 90}[v.q % 8]; });
  check("dragon", 10, 2, [](std::size_t n, Valuation v) { return (n >> (v.z + 1)) % 2 == 0 ? 90.0 : -90.0; });
  check("terdragon", 6, 3, [](std::size_t, Valuation v) { return v.q % 3 == 1 ? 120.0 : -120.0; });
  check("sierpinski", 6, 3,
        [](std::size_t, Valuation v) { return (6 - v.z + static_cast<int>((v.q + 2) / 3)) % 2 == 0 ? 60.0 : -60.0; });
  check("r5dragon", 5, 5, [](std::size_t, Valuation v) { return v.q % 5 <= 2 ? 90.0 : -90.0; });
  check("altpaper", 10, 2, [](std::size_t n, Valuation v) {
    return (n >> (v.z + 1)) % 2 == static_cast<std::size_t>((v.z + 9) % 2) ? 90.0 : -90.0;
  });
  // With half turns, where + and - 180 degrees are the same.
  const auto check_modulo = [](const char* motif, int levels, auto expected) {
    const std::vector<Vec2> points = curve(motif, levels);
    for (std::size_t n = 1; n + 1 < points.size(); ++n) {
      const double difference = std::remainder(turn_degrees(points, n) - expected(valuation(n, 2).z), 360.0);
      EXPECT_NEAR(difference, 0.0, 1e-6) << motif << " vertex " << n;
    }
  };
  check_modulo("levy", 8, [](int z) { return 90.0 * (1 - z); });
  for (const int levels : {9, 10}) {
    check_modulo("polya", levels, [&](int z) { return z % 2 == 1 ? 180.0 : levels % 2 == 1 ? 90.0 : -90.0; });
  }
}

TEST(TwoPoint, DistinctVertices) {
  const json expected = testing::reference("curves.json")["A_distinct_vertices"];
  for (const auto& [motif, counts] : expected.items()) {
    for (std::size_t level = 1; level <= counts.size(); ++level) {
      std::set<std::pair<long long, long long>> distinct;
      for (const Vec2 p : curve(motif, static_cast<int>(level))) {
        distinct.emplace(std::llround(p.x * 1e9), std::llround(p.y * 1e9));
      }
      EXPECT_EQ(distinct.size(), counts[level - 1].get<std::size_t>()) << motif << level;
    }
  }
}

TEST(TwoPoint, ALevelKeepsTheVerticesOfTheOneBeforeBitForBit) {
  const std::pair<const char*, std::size_t> motifs[] = {
      {"koch", 4}, {"dragon", 2}, {"sierpinski", 3}, {"minkowski", 8}};
  for (const auto& [motif, k] : motifs) {
    std::vector<Vec2> before = curve(motif, 0);
    for (int level = 1; level <= (k == 2 ? 14 : 7) && std::pow(k, level) < 1e6; ++level) {
      const std::vector<Vec2> points = curve(motif, level);
      for (std::size_t i = 0; i < before.size(); ++i) ASSERT_EQ(points[i * k], before[i]) << motif << level;
      before = points;
    }
  }
}

TEST(TwoPoint, RetainedPointsAreEveryKthOfTheirPath) {
  const curves::Family& family = *find_family("two-point");
  const auto every = [&](const std::string& text) { return family.retained_every(two_point(text)); };
  EXPECT_EQ(every(R"({"motif": "koch", "levels": 5})"), 4U);
  EXPECT_EQ(every(R"({"motif": "dragon", "levels": 1})"), 2U);
  EXPECT_EQ(every(R"({"motif": "koch", "levels": 0})"), 0U);  // all of S_0 is new
  EXPECT_EQ(every(R"({"motif": "hilbert", "levels": 4})"), 0U);
  const std::string mixed =
      R"({"motif": {"by_level": [{"marks": [[0.5, 0.3]]}, {"marks": [["1/3", 0.2], ["2/3", -0.2]]}]}, "levels": )";
  EXPECT_EQ(every(mixed + "3}"), 2U);
  EXPECT_EQ(every(mixed + "4}"), 3U);
  const std::vector<Vec2> before = draw_points(two_point(mixed + "3}"));
  const std::vector<Vec2> after = draw_points(two_point(mixed + "4}"));
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[3 * i], before[i]);
}

/// Parameters that between them take every road through the engine.
const std::vector<std::string>& roads() {
  static const std::vector<std::string> all{
      R"({"motif": "koch", "levels": 7})",
      R"({"motif": "dragon", "levels": 14, "base": "square"})",
      R"({"motif": "sierpinski", "levels": 8, "base": {"points": [[0,0],[2,1],[3,-1]]}})",
      R"({"motif": {"turtle": "F+F-F--F+F+F", "angle": 72}, "levels": 5, "base": {"shape": "star", "n": 5}})",
      R"({"motif": "koch", "sign": "random", "levels": 6, "base": "triangle"})",
      R"({"motif": "koch", "sign": [1, -1, -1], "levels": 6})",
      R"({"motif": "levy", "sign": "level-edge", "levels": 11})",
      R"({"motif": {"by_level": [{"marks": [[0.5, 0.3]]}, {"marks": [["1/3", 0.2], ["2/3", -0.2]]}]}, "sign": "edge", "levels": 9})",
      R"({"motif": {"by_edge": [[[0.5, 0.3]], [[0.4, -0.2]], [[0.6, 0.1]]]}, "levels": 10})",
      R"({"motif": {"marks": [[0.3, {"random": [0, 0.3]}], [{"random": [0.5, 0.7]}, -0.1]]}, "levels": 7})",
      R"({"motif": {"marks": [[0.5, "0.3*(rand-0.5)/level"]]}, "levels": 9})",
      R"({"motif": {"marks": [[0.3, 0.5], [0.6, -0.25]], "beta": "absolute", "decay": 0.5}, "sign": "edge", "levels": 6})",
      R"({"motif": {"marks": [[0.5, 0.4]], "decay": 0.8}, "sign": "level", "levels": 11})"};
  return all;
}

TEST(TwoPoint, EveryVertexIsReadByItsAddress) {
  for (const std::string& road : roads()) {
    const TwoPointParams params = two_point(road);
    const std::vector<Vec2> points = draw_points(params, 77);
    for (std::uint64_t n = 0; n < points.size(); n += 1 + n % 37) {
      const std::optional<Vec2> vertex = vertex_at(params, 77, n);
      ASSERT_TRUE(vertex.has_value()) << road << n;
      ASSERT_EQ(*vertex, points[n]) << road << n;
    }
    const bool closed = params.base.polylines.front().closed;
    EXPECT_EQ(vertex_at(params, 77, points.size() - 1).has_value(), true) << road;
    EXPECT_EQ(vertex_at(params, 77, points.size()), std::nullopt) << road << closed;
  }
}

TEST(TwoPoint, AnAddressReachesAnyDepth) {
  // koch(1/3) = (5 - i sqrt 3)/14 is reached by the digits 1, 1, 1 ...: 1/3 = 0.111... in base 4.
  const TwoPointParams params = two_point(R"({"motif": "koch", "levels": 200})");
  const std::vector<std::uint32_t> ones(200, 1);
  const Vec2 vertex = vertex_at(params, 0, {0, ones});
  EXPECT_NEAR(vertex.x, 5.0 / 14, 1e-14);
  EXPECT_NEAR(vertex.y, -std::sqrt(3.0) / 14, 1e-14);
  // dragon(1/3) = (1 - 2i)/5: 1/3 = 0.0101... in base 2.
  std::vector<std::uint32_t> digits(1000);
  for (std::size_t i = 1; i < digits.size(); i += 2) digits[i] = 1;
  const Vec2 dragon = vertex_at(two_point(R"({"motif": "dragon", "levels": 1000})"), 0, {0, digits});
  EXPECT_NEAR(dragon.x, 0.2, 1e-14);
  EXPECT_NEAR(dragon.y, -0.4, 1e-14);
}

TEST(TwoPoint, AViewGivesASubsetOfTheFullRunsPoints) {
  for (const std::string& road : roads()) {
    const TwoPointParams params = two_point(road);
    const std::vector<Vec2> full = draw_points(params, 5);
    for (std::uint64_t trial = 0; trial < 12; ++trial) {
      DrawContext context{.seed = 5};
      context.view.tolerance = std::pow(10.0, -4.0 * uniform(1, trial));
      if (trial % 2 == 1) {
        const Vec2 centre = full[random_bits(2, trial) % full.size()];
        context.view.box = Box2{centre, centre}.grown(0.2 * uniform(3, trial));
      }
      const std::vector<Vec2> seen = record("two-point", params, context).all_points();
      std::size_t at = 0;
      for (const Vec2 p : seen) {
        while (at < full.size() && full[at] != p) ++at;
        ASSERT_LT(at, full.size()) << road << " trial " << trial;
        ++at;
      }
    }
  }
}

TEST(TwoPoint, TheViewHidesNothingLargerThanItsTolerance) {
  for (const std::string& road : roads()) {
    const TwoPointParams params = two_point(road);
    const std::vector<Vec2> full = draw_points(params, 5);
    constexpr double tolerance = 0.02;
    const std::vector<Vec2> seen =
        record("two-point", params, {.seed = 5, .view = {Box2::everything(), tolerance}}).all_points();
    // Every point of the full run lies near one of the chords that stand for it.
    std::size_t at = 0;
    for (const Vec2 p : full) {
      if (at + 1 < seen.size() && p == seen[at + 1]) ++at;
      const Vec2 a = seen[at];
      const Vec2 d = (at + 1 < seen.size() ? seen[at + 1] : seen[0]) - a;
      const double t = length_squared(d) > 0 ? std::clamp(dot(p - a, d) / length_squared(d), 0.0, 1.0) : 0.0;
      ASSERT_LE(distance(p, a + t * d), 2 * tolerance) << road;
    }
  }
}

TEST(TwoPoint, LevelsBeyondAllNumbersCostWhatIsSeen) {
  for (const char* motif : {"koch", "sierpinski", "dragon", "levy", "terdragon", "minkowski"}) {
    const TwoPointParams params = two_point(R"({"levels": 1000, "motif": ")" + std::string(motif) + R"("})");
    const DrawContext context{.seed = 1, .view = {Box2::everything(), 0.01}};
    const Family& family = *find_family("two-point");
    const Forecast forecast = family.forecast(params, context, 1e7);
    EXPECT_TRUE(forecast.exact) << motif;
    EXPECT_EQ(forecast.points, static_cast<double>(record("two-point", params, context).all_points().size())) << motif;
    EXPECT_GT(forecast.asked_points, 1e300) << motif;
    EXPECT_LT(forecast.points, 1e6) << motif;
  }
}

TEST(TwoPoint, AZoomCostsWhatItShows) {
  // curves.md A.5: 1/3 of the way is (5 - i sqrt 3)/14.
  const Vec2 target{5.0 / 14, -std::sqrt(3.0) / 14};
  const TwoPointParams params = two_point(R"({"motif": "koch", "levels": 60})");
  for (const double zoom : {1e3, 1e6, 1e9}) {
    const View view{Box2{target, target}.grown(0.5 / zoom), 1e-3 / zoom};
    const Recording seen = record("two-point", params, {.view = view});
    std::size_t inside = 0;
    for (const Vec2 p : seen.all_points()) inside += view.box.contains(p) ? 1U : 0U;
    EXPECT_GT(inside, 100U) << zoom;
    EXPECT_LT(seen.all_points().size(), 20000U) << zoom;
  }
}

TEST(TwoPoint, SimilaritiesOfTheBaseCarryTheCurve) {
  for (const std::string& road : roads()) {
    if (road.find("absolute") != std::string::npos) continue;
    TwoPointParams params = two_point(road);
    const std::vector<Vec2> before = draw_points(params, 9);
    const Affine2 map = translation({3, -2}) * scaling(2.5, 2.5) * rotation_degrees(37);
    for (Polyline& polyline : params.base.polylines) {
      for (Vec2& p : polyline.points) p = map(p);
    }
    const std::vector<Vec2> after = draw_points(params, 9);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) ASSERT_LT(distance(map(before[i]), after[i]), 1e-12) << road;
  }
}

TEST(TwoPoint, AReflectedBaseIsTheOppositeSign) {
  const std::vector<Vec2> plus = curve("koch", 5, R"(, "sign": [1])");
  const std::vector<Vec2> minus = curve("koch", 5, R"(, "sign": [-1])");
  for (std::size_t i = 0; i < plus.size(); ++i) EXPECT_EQ(plus[i], (Vec2{minus[i].x, -minus[i].y}));
}

TEST(TwoPoint, FlagsAndRulesAgreeOnOneEdge) {
  // curves.md A.2.
  const std::pair<std::string, std::string> pairs[] = {
      {R"({"motif": "dragon", "levels": 12})", R"({"motif": "levy", "sign": "edge", "levels": 12})"},
      {R"({"motif": {"marks": [[0.5, 0.5]], "flip": [1, 1]}, "levels": 11})",
       R"({"motif": "levy", "sign": "level", "levels": 11})"},
      {R"({"motif": {"marks": [[0.5, 0.5]], "flip": [1, 1], "reverse": [0, 1]}, "levels": 11})",
       R"({"motif": "levy", "sign": "level-edge", "levels": 11})"},
      {R"({"motif": "sierpinski", "levels": 7})", R"({"motif": "sierpinski", "sign": "level-edge", "levels": 7})"}};
  for (const auto& [flags, rule] : pairs) {
    const std::vector<Vec2> a = draw_points(two_point(flags));
    const std::vector<Vec2> b = draw_points(two_point(rule));
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_LT(distance(a[i], b[i]), 1e-12) << flags;
  }
  // On a triangle they differ by more than an edge.
  const std::vector<Vec2> flags = curve("sierpinski", 4, R"(, "base": "triangle")");
  const std::vector<Vec2> rule = curve("sierpinski", 4, R"(, "base": "triangle", "sign": "level-edge")");
  double farthest = 0.0;
  for (std::size_t i = 0; i < flags.size(); ++i) farthest = std::max(farthest, distance(flags[i], rule[i]));
  EXPECT_GT(farthest, 1.0 / 16);
}

TEST(TwoPoint, JoinPointsStandForTheVertices) {
  const auto joined = [](const std::string& motif, int levels, const std::string& base) {
    return draw_points(two_point(R"({"motif": )" + motif + R"(, "levels": )" + std::to_string(levels) +
                                 R"(, "base": ")" + base + R"("})"));
  };
  // Of the edge itself, to the right of travel.
  EXPECT_EQ(joined(R"({"name": "koch", "join": [0.25, 0.5]})", 0, "segment"), (std::vector<Vec2>{{0.25, -0.5}}));
  // Mirrored edges have it on their left, reversed ones count from their far end.
  EXPECT_EQ(joined(R"("hilbert")", 1, "segment"),
            (std::vector<Vec2>{{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.75}, {0.75, 0.25}}));
  const std::vector<Vec2> levy = joined(R"({"name": "levy", "reverse": [0, 1], "join": [0.25, 0]})", 1, "segment");
  ASSERT_EQ(levy.size(), 2U);
  EXPECT_LT(distance(levy[0], {0.125, -0.125}), 1e-15);
  EXPECT_LT(distance(levy[1], {0.875, -0.125}), 1e-15);
  // As many as edges, on closed bases too; each on the edge whose middle it is.
  const std::vector<Vec2> edges = joined(R"("terdragon")", 4, "square");
  const std::vector<Vec2> middles = joined(R"({"name": "terdragon", "join": [0.5, 0]})", 4, "square");
  ASSERT_EQ(middles.size(), edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    EXPECT_LT(distance(middles[i], 0.5 * (edges[i] + edges[(i + 1) % edges.size()])), 1e-14);
  }
  // No view leaves any out.
  const TwoPointParams params = two_point(R"({"motif": "hilbert", "levels": 5})");
  const DrawContext far{.view = {Box2{{7, 7}, {8, 8}}, 0.5}};
  EXPECT_EQ(record("two-point", params, far).all_points(), draw_points(params));
}

TEST(TwoPoint, RandomDrawsHangOnTheirNodeAlone) {
  const std::string random = R"({"motif": {"marks": [[{"random": [0.3, 0.7]}, {"random": [-0.4, 0.4]}]]}, "levels": )";
  const std::vector<Vec2> coarse = draw_points(two_point(random + "6}"), 3);
  const std::vector<Vec2> fine = draw_points(two_point(random + "7}"), 3);
  const std::vector<Vec2> other = draw_points(two_point(random + "6}"), 4);
  for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_EQ(coarse[i], fine[2 * i]);
  EXPECT_NE(coarse, other);
  // Alpha and beta of one marker are independent, and spread over their whole ranges.
  Box2 marks;
  double correlation = 0.0;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    const Vec2 mark = draw_points(two_point(random + "1}"), seed)[1];
    marks.add(mark);
    correlation += (mark.x - 0.5) * mark.y;
  }
  EXPECT_NEAR(marks.low.x, 0.3, 1e-3);
  EXPECT_NEAR(marks.high.x, 0.7, 1e-3);
  EXPECT_NEAR(marks.low.y, -0.4, 2e-3);
  EXPECT_NEAR(marks.high.y, 0.4, 2e-3);
  EXPECT_NEAR(correlation / 4000, 0.0, 2e-3);
}

TEST(TwoPoint, ExpressionsSeeLevelEdgeAndMarker) {
  const std::vector<Vec2> points =
      draw_points(two_point(R"({"motif": {"marks": [["marker/3", "level*edge/100"], ["marker/3", 0]]}, "levels": 2})"));
  EXPECT_NEAR(points[3].y, -0.01, 1e-15);     // level 1, edge 1, marker 1
  const Vec2 middle = points[6] - points[3];  // level 2, edge 2
  const Vec2 offset = points[4] - (points[3] + (1.0 / 3) * middle);
  EXPECT_NEAR(dot(offset, {middle.y, -middle.x}) / length_squared(middle), 0.04, 1e-12);
}

TEST(TwoPoint, SeveralPolylinesCountTheirEdgesTogether) {
  const std::vector<Vec2> points =
      draw_points(two_point(R"({"base": {"path": "M0 0H1M0 2H1"}, "motif": "levy", "sign": "edge", "levels": 1})"));
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(points[1], (Vec2{0.5, -0.5}));
  EXPECT_EQ(points[4], (Vec2{0.5, -1.5}));
}

}  // namespace
}  // namespace burin::curves
