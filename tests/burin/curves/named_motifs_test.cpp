#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <burin/curves/two_point/dimension.hpp>
#include <burin/curves/two_point/named_motifs.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// The motifs that go by a name: their rows, and the exact properties of curves.md A.5.
namespace burin::curves::two_point {
namespace {

using burin::testing::draw_points;
using nlohmann::json;

/// Vertices of a named motif's curve on one edge, or on the given base.
std::vector<Vec2> curve(std::string_view motif, int levels, const json& base = "segment") {
  const json params = {{"motif", motif}, {"levels", levels}, {"base", base}};
  return draw_points(burin::testing::two_point(params.dump()));
}

double polygon_area(const std::vector<Vec2>& points) {
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) area += 0.5 * cross(points[i], points[(i + 1) % points.size()]);
  return area;
}

double row_dimension(std::string_view name) {
  return similarity_dimension(motif_from(*find_motif(name))).value_or(0.0);
}

TEST(NamedMotifs, EveryRowSaysWhatItIs) {
  std::set<std::string_view> names;
  for (const NamedMotif& row : named_motifs()) {
    EXPECT_FALSE(row.summary.empty()) << row.name;
    EXPECT_FALSE(row.source.empty()) << row.name;
    EXPECT_LE(row.summary.size(), 90U) << row.name;
    EXPECT_NE(row.turtle.empty(), row.points.empty()) << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(row.alias.empty() || names.insert(row.alias).second) << row.alias;
    EXPECT_EQ(find_motif(row.name), &row);
    EXPECT_TRUE(row.alias.empty() || find_motif(row.alias) == &row) << row.alias;
    // Letters that flag nothing would be a slip.
    for (const std::string_view letters : {row.flip, row.reverse}) {
      for (const char c : letters) EXPECT_NE(row.turtle.find(c), std::string_view::npos) << row.name;
    }
  }
  EXPECT_EQ(find_motif(""), nullptr);
  EXPECT_EQ(find_motif("koc"), nullptr);
}

TEST(NamedMotifs, DimensionsAreTheReferences) {
  const json generators = burin::testing::reference("curves.json")["A_generators"];
  for (const auto& [name, generator] : generators.items()) {
    EXPECT_NEAR(row_dimension(name == "cesaro85" ? "cesaro" : name), generator["dim"].get<double>(), 1e-9) << name;
  }
  // curves.md A.3, in closed form.
  EXPECT_NEAR(row_dimension("koch"), std::log(4.0) / std::log(3.0), 1e-14);
  EXPECT_NEAR(row_dimension("quad18"), std::log(18.0) / std::log(6.0), 1e-14);
  EXPECT_NEAR(row_dimension("sierpinski"), std::log(3.0) / std::log(2.0), 1e-14);
  EXPECT_NEAR(row_dimension("quad32"), 5.0 / 3, 1e-14);
}

TEST(NamedMotifs, DimensionsOfTheOthersAreInClosedForm) {
  EXPECT_NEAR(row_dimension("altterdragon"), 2.0, 1e-14);
  EXPECT_NEAR(row_dimension("quartet"), 2.0, 1e-14);
  EXPECT_NEAR(row_dimension("dekking"), 2.0, 1e-14);
  EXPECT_NEAR(row_dimension("gosper-side"), std::log(9.0) / std::log(7.0), 1e-14);
  const double golden = (1 + std::sqrt(5.0)) / 2;
  EXPECT_NEAR(row_dimension("pentigree"), std::log(6.0) / std::log(golden * golden), 1e-14);
}

TEST(NamedMotifs, ADimensionNeedsOneMotifThatContracts) {
  const auto dimension = [](const char* motif) {
    return similarity_dimension(burin::testing::two_point(std::string(R"({"motif": )") + motif + "}").motif);
  };
  EXPECT_NEAR(dimension(R"({"marks": [[0.5, 0]]})").value_or(0), 1.0, 1e-12);
  EXPECT_NEAR(dimension(R"({"marks": [[0.5, 0], [0.5, 0]]})").value_or(0), 1.0, 1e-12);  // an edge of no length
  EXPECT_NEAR(dimension(R"({"marks": [["1/4", "sqrt(3)/4"]], "reverse": [1, 0]})").value_or(0), 2.0, 1e-12);
  for (const char* motif :
       {R"({"marks": [[0, 1]]})", R"({"marks": [[0.5, {"random": [0, 0.1]}]]})", R"({"marks": [[0.5, "level/9"]]})",
        R"({"marks": [[0.5, 0.1]], "beta": "absolute"})", R"({"marks": [[0.5, 0.1]], "decay": 0.9})",
        R"({"by_level": ["koch", "levy"]})", R"({"by_edge": [[[0.5, 0.1]], [[0.5, 0.2]]]})"}) {
    EXPECT_EQ(dimension(motif), std::nullopt) << motif;
  }
}

TEST(NamedMotifs, APresetMayWriteAnotherAngle) {
  const auto named = [](const char* motif) {
    return draw_points(burin::testing::two_point(std::string(R"({"levels": 4, "motif": )") + motif + "}"));
  };
  EXPECT_EQ(named(R"({"name": "cesaro", "angle": 60})"), named(R"("koch")"));
  EXPECT_EQ(named(R"({"name": "cesaro"})"), named(R"("cesaro")"));
  EXPECT_EQ(named(R"({"name": "heighway", "reverse": [0, 0]})"), named(R"("levy")"));
  EXPECT_EQ(named(R"({"name": "dragon", "sign": "constant"})"), named(R"("levy")"));
  EXPECT_EQ(named(R"({"name": "gosper", "reverse": "B"})"), named(R"("gosper")"));
  // curves.md A.3: q = 1/(2 + 2 cos angle), apex q sin angle.
  for (const double angle : {10.0, 45.0, 60.0, 80.0, 90.0, 120.0}) {
    const std::vector<Vec2> points = draw_points(
        burin::testing::two_point(json({{"levels", 1}, {"motif", {{"name", "cesaro"}, {"angle", angle}}}}).dump()));
    const double radians = angle * M_PI / 180;
    const double q = 1 / (2 + 2 * std::cos(radians));
    ASSERT_EQ(points.size(), 5U);
    EXPECT_NEAR(points[1].x, q, 1e-14);
    EXPECT_NEAR(points[2].y, -q * std::sin(radians), 1e-14);
  }
}

TEST(NamedMotifs, OneEdgeHasTheReferencesArea) {
  // curves.md A.5; positive: the path bulges to the right of its chord.
  const double root3 = std::sqrt(3.0);
  const std::pair<const char*, double> areas[] = {{"koch", root3 / 36},
                                                  {"minkowski", 0},
                                                  {"quad18", 0},
                                                  {"quad32", 0},
                                                  {"terdragon", 0},
                                                  {"r5dragon", 0},
                                                  {"peano9", 0},
                                                  {"quad5", 1. / 9},
                                                  {"levy", 0.25},
                                                  {"dragon", 0.25},
                                                  {"polya", 0.25},
                                                  {"altpaper", 0.25},
                                                  {"sierpinski", 3 * root3 / 16},
                                                  {"gosper", root3 / 7},
                                                  {"hilbert4", -0.5}};
  for (const auto& [name, area] : areas) EXPECT_NEAR(polygon_area(curve(name, 1)), area, 1e-14) << name;
}

TEST(NamedMotifs, AClosedPolygonGrowsByTheAreaLaw) {
  // A_L = A_0 + a sum |d|^2 (1 - q^L)/(1 - q) with q = sum |r|^2, for motifs without flags.
  const json base = {{"points", {{0, 0}, {3, 0}, {4, 2}, {1, 3}}}, {"closed", true}};
  const double area0 = polygon_area(curve("koch", 0, base));
  const double squares = 9 + 5 + 10 + 10;
  for (const NamedMotif& row : named_motifs()) {
    if (!row.flip.empty() || !row.reverse.empty() || row.sign || row.join) continue;
    const double a = polygon_area(curve(row.name, 1));
    double q = 0.0;
    for (const double r : edge_ratios(motif_from(row).by_level.front().by_edge.front())) q += r * r;
    double growth = 0.0;
    double term = 1.0;
    for (int level = 1; level <= 3; ++level, term *= q) {
      growth += term;
      const double expected = area0 + a * squares * growth;
      EXPECT_NEAR(polygon_area(curve(row.name, level, base)), expected, 1e-11 * (1 + std::abs(expected)))
          << row.name << level;
    }
  }
}

std::pair<long long, long long> cell(Vec2 p) {
  return {std::llround(p.x * 1e9), std::llround(p.y * 1e9)};
}

TEST(NamedMotifs, NoEdgeIsDrawnTwice) {
  const std::pair<const char*, int> motifs[] = {{"heighway", 10}, {"altpaper", 10},    {"terdragon", 7}, {"gosper", 4},
                                                {"r5dragon", 5},  {"altterdragon", 7}, {"quartet", 4},   {"dekking", 2},
                                                {"peano9", 3},    {"quad5", 5}};
  const auto distinct_edges = [](const char* name, int levels) {
    const std::vector<Vec2> points = curve(name, levels);
    std::set<std::pair<std::pair<long long, long long>, std::pair<long long, long long>>> edges;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      edges.insert(std::minmax(cell(points[i]), cell(points[i + 1])));
    }
    return edges.size() + 1 == points.size();
  };
  for (const auto& [name, levels] : motifs) EXPECT_TRUE(distinct_edges(name, levels)) << name;
  for (const char* name : {"levy", "polya", "hilbert4"}) EXPECT_FALSE(distinct_edges(name, 5)) << name;
}

TEST(NamedMotifs, NoVertexIsPassedTwice) {
  const std::pair<const char*, int> motifs[] = {{"koch", 6},       {"minkowski", 4}, {"quad18", 3}, {"quad32", 2},
                                                {"sierpinski", 8}, {"gosper", 4},    {"cesaro", 6}};
  for (const auto& [name, levels] : motifs) {
    const std::vector<Vec2> points = curve(name, levels);
    std::set<std::pair<long long, long long>> distinct;
    for (const Vec2 p : points) distinct.insert(cell(p));
    EXPECT_EQ(distinct.size(), points.size()) << name;
  }
}

TEST(NamedMotifs, LevysCurveReachesItsLimitAtAThird) {
  // 1/3 = 0.0101... in base 2; levy(1/3) = -i.
  std::vector<std::uint32_t> digits(1000);
  for (std::size_t i = 1; i < digits.size(); i += 2) digits[i] = 1;
  const Vec2 p = vertex_at(burin::testing::two_point(R"({"motif": "levy", "levels": 1000})"), 0, {0, digits});
  EXPECT_NEAR(p.x, 0.0, 1e-14);
  EXPECT_NEAR(p.y, -1.0, 1e-14);
}

TEST(NamedMotifs, RigidMotionsOfTheBaseCarryAbsoluteMarks) {
  TwoPointParams params = burin::testing::two_point(
      R"({"motif": {"marks": [[0.3, 0.5], [0.6, -0.25]], "beta": "absolute", "decay": 0.5}, "levels": 5,
          "base": {"points": [[0,0],[2,1],[3,-1]]}})");
  const std::vector<Vec2> before = draw_points(params);
  const Affine2 map = translation({3, -2}) * rotation_degrees(37);
  for (Vec2& p : params.base.polylines.front().points) p = map(p);
  const std::vector<Vec2> after = draw_points(params);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT(distance(map(before[i]), after[i]), 1e-12);
}

}  // namespace
}  // namespace burin::curves::two_point
