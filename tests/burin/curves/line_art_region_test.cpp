#include <algorithm>
#include <any>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/curves/line_art/draws.hpp>
#include <burin/curves/line_art/line_art.hpp>

#include "support/json_value.hpp"

/// Regions of line art: their places lie in them, uniformly.
namespace burin::curves::line_art {
namespace {

constexpr std::uint64_t place_count = 20'000;

Region region_from(const std::string& json, const ReadFile& files = {}) {
  const testing::ReadParams read = testing::read_params("line-art", R"({"start": )" + json + "}", files);
  EXPECT_TRUE(read.params.has_value()) << json << '\n' << problems_text(read.problems);
  return read.params ? std::any_cast<LineArtParams>(*read.params).start : Region{};
}

std::vector<Vec2> places_of(const Region& region, Places places = Places::random) {
  std::vector<Vec2> all;
  for (std::uint64_t j = 0; j < place_count; ++j) {
    all.push_back(place_in(region, {.seed = 11,
                                    .x_draw = draws::start_x,
                                    .y_draw = draws::start_y,
                                    .index = j,
                                    .count = place_count,
                                    .places = places}));
  }
  return all;
}

/// Holds the counts of `bins` cells of equal measure against chi-squared at 1 in 10,000: mean n, variance 2n.
void expect_uniform(const std::vector<Vec2>& places, int bins, const std::function<int(Vec2)>& bin_of) {
  std::vector<int> counts(static_cast<std::size_t>(bins));
  for (const Vec2 p : places) {
    const int bin = bin_of(p);
    ASSERT_TRUE(bin >= 0 && bin < bins) << p.x << ' ' << p.y;
    ++counts[static_cast<std::size_t>(bin)];
  }
  const double expected = static_cast<double>(places.size()) / bins;
  double chi_squared = 0.0;
  for (const int count : counts) chi_squared += (count - expected) * (count - expected) / expected;
  const double freedom = bins - 1;
  // Wilson and Hilferty: the cube root of chi-squared a degree is nearly normal.
  const double z =
      (std::cbrt(chi_squared / freedom) - (1.0 - 2.0 / (9.0 * freedom))) / std::sqrt(2.0 / (9.0 * freedom));
  EXPECT_LT(z, 3.72);
  EXPECT_GT(z, -3.72);
}

int bin(double share, int bins) {
  return std::min(static_cast<int>(std::floor(share * bins)), bins - 1);
}

double turn_share(Vec2 v) {
  const double share = math::atan2(v.y, v.x) / math::tau;
  return share < 0.0 ? share + 1.0 : share;
}

TEST(LineArtRegions, RectanglesAndSegmentsAreFilledUniformly) {
  expect_uniform(places_of(region_from("[2, -1, 5, 1]")), 100,
                 [](Vec2 p) { return 10 * bin((p.x - 2.0) / 3.0, 10) + bin((p.y + 1.0) / 2.0, 10); });
  expect_uniform(places_of(region_from(R"({"segment": [0, 0, 4, 2]})")), 50, [](Vec2 p) {
    EXPECT_DOUBLE_EQ(p.y, 0.5 * p.x);
    return bin(p.x / 4.0, 50);
  });
}

TEST(LineArtRegions, DiscsAndRingsAreFilledUniformly) {
  expect_uniform(places_of(region_from(R"({"disc": [1, 1, 2]})")), 100, [](Vec2 p) {
    const Vec2 v = p - Vec2{1.0, 1.0};
    EXPECT_LE(length(v), 2.0 * (1.0 + 1e-15));
    return 10 * bin(length_squared(v) / 4.0, 10) + bin(turn_share(v), 10);
  });
  expect_uniform(places_of(region_from(R"({"ring": [0, 0, 1, 2]})")), 100, [](Vec2 p) {
    EXPECT_GE(length(p), 1.0 - 1e-15);
    return 10 * bin((length_squared(p) - 1.0) / 3.0, 10) + bin(turn_share(p), 10);
  });
}

TEST(LineArtRegions, PolygonsAreFilledUniformlyByTheEvenOddRule) {
  const Region l_shape = region_from(R"({"polygon": {"points": [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]}})");
  expect_uniform(places_of(l_shape), 75, [](Vec2 p) {
    const int square = p.x >= 1.0 ? 1 : p.y >= 1.0 ? 2 : 0;
    return 25 * square + 5 * bin(p.x - std::floor(p.x), 5) + bin(p.y - std::floor(p.y), 5);
  });
  const Region with_hole =
      region_from(R"({"polygon": {"path": "M0 0 H3 V-3 H0 Z M1 -1 H2 V-2 H1 Z"}})");  // y down in SVG
  expect_uniform(places_of(with_hole), 8, [](Vec2 p) {
    const int cell = 3 * bin(p.y / 3.0, 3) + bin(p.x / 3.0, 3);
    return cell == 4 ? -1 : cell - (cell > 4 ? 1 : 0);
  });
}

TEST(LineArtRegions, LinesAreFilledByTheirLength) {
  // Edges of 1, 3 and 4.
  expect_uniform(places_of(region_from(R"({"along": {"points": [[0, 0], [1, 0], [1, 3], [5, 3]]}})")), 64, [](Vec2 p) {
    const double along = p.y == 0.0 ? p.x : p.y < 3.0 ? 1.0 + p.y : 4.0 + (p.x - 1.0);
    return bin(along / 8.0, 64);
  });
}

TEST(LineArtRegions, PointsComeFromAFileAndAreMetAlike) {
  const ReadFile files = [](std::string_view) -> Result<std::string> { return std::string("0,0\n1,0\n2,5\n3,1\n"); };
  const Region set = region_from(R"({"points": {"csv": "towns.csv"}})", files);
  expect_uniform(places_of(set), 4, [](Vec2 p) { return static_cast<int>(p.x); });
  const std::vector<Vec2> in_turn = places_of(set, Places::steps);
  EXPECT_EQ(in_turn.front(), (Vec2{0.0, 0.0}));
  EXPECT_EQ(in_turn[place_count / 2], (Vec2{2.0, 5.0}));
  EXPECT_EQ(in_turn.back(), (Vec2{3.0, 1.0}));
}

TEST(LineArtRegions, EvenPlacesLeaveNoGaps) {
  // Of the cells that chance fills with 4 places each, it leaves 1.8 % empty; a sequence of low discrepancy none.
  const std::vector<Vec2> even = places_of(region_from("[0, 0, 1, 1]"), Places::even);
  std::vector<int> counts(70 * 70);
  for (const Vec2 p : even) ++counts[static_cast<std::size_t>(70 * bin(p.y, 70) + bin(p.x, 70))];
  for (const int count : counts) EXPECT_GT(count, 0);
  const std::vector<Vec2> steps = places_of(region_from(R"({"segment": [0, 0, 1, 0]})"), Places::steps);
  for (std::uint64_t j = 1; j < place_count; ++j) {
    EXPECT_NEAR(steps[j].x - steps[j - 1].x, 1.0 / static_cast<double>(place_count), 1e-12);
  }
}

TEST(LineArtRegions, CrossingsAreWhereTheBorderIs) {
  const auto crossings = [](const std::string& json, Vec2 a, Vec2 b) {
    std::vector<double> all;
    region_from(json).add_crossings(a, b, all);
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(crossings("[1, -1, 2, 1]", {0.0, 0.0}, {4.0, 0.0}), (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(crossings(R"({"disc": [2, 0, 1]})", {0.0, 0.0}, {4.0, 0.0}), (std::vector<double>{0.25, 0.75}));
  EXPECT_EQ(crossings(R"({"ring": [4, 0, 1, 2]})", {0.0, 0.0}, {8.0, 0.0}),
            (std::vector<double>{0.25, 0.375, 0.625, 0.75}));
  EXPECT_EQ(crossings(R"({"polygon": {"points": [[1, -1], [3, -1], [1, 1]]}})", {0.0, 0.0}, {4.0, 0.0}),
            (std::vector<double>{0.25, 0.5}));
  EXPECT_TRUE(crossings(R"({"disc": [2, 3, 1]})", {0.0, 0.0}, {4.0, 0.0}).empty());
}

}  // namespace
}  // namespace burin::curves::line_art
