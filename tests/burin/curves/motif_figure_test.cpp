#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/curves/two_point/motif_figure.hpp>
#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

#include "support/json_value.hpp"

namespace burin::curves::two_point {
namespace {

std::vector<MotifFigure> figures_of(const std::string& motif) {
  const TwoPointParams params = burin::testing::two_point(R"({"motif": )" + motif + "}");
  return motif_figures(params.motif, params.sign, 7).value_or(std::vector<MotifFigure>{});
}

constexpr Box2 area{{20, 20}, {220, 120}};

/// One layer's paths of a drawing.
std::vector<std::vector<Vec2>> drawn_paths(const std::vector<MotifFigure>& figures, const std::string& layer) {
  class Keep final : public PathSink {
   public:
    Flow begin(const PathHead& head) override {
      heads.push_back(head);
      paths.emplace_back();
      return Flow::go;
    }
    Flow points(std::span<const Vec2> points) override {
      paths.back().insert(paths.back().end(), points.begin(), points.end());
      return Flow::go;
    }
    Flow contour() override { return Flow::go; }
    Flow end() override { return Flow::go; }
    std::vector<PathHead> heads;
    std::vector<std::vector<Vec2>> paths;
  };
  Keep keep;
  Checked checked(keep);
  EXPECT_EQ(draw_motif_figures(figures, area, checked), Flow::go);
  const Sheet sheet = motif_sheet({});
  std::vector<std::vector<Vec2>> wanted;
  for (std::size_t i = 0; i < keep.paths.size(); ++i) {
    EXPECT_EQ(keep.heads[i].paint, sheet.layers.at(keep.heads[i].layer).paint);
    if (sheet.layers.at(keep.heads[i].layer).name == layer) wanted.push_back(keep.paths[i]);
  }
  return wanted;
}

TEST(MotifFigure, EveryStageAndEveryListHasOne) {
  EXPECT_EQ(figures_of(R"("koch")").size(), 1U);
  EXPECT_EQ(figures_of(R"({"by_level": ["koch", "levy", "minkowski"]})").size(), 3U);
  EXPECT_EQ(figures_of(R"({"by_edge": [[[0.5, 0.1]], [[0.5, 0.2]]]})").size(), 2U);
  EXPECT_EQ(figures_of(R"({"marks": [[0.5, {"random": [0.1, 0.2]}]]})").front().path.size(), 3U);
  EXPECT_TRUE(figures_of(R"({"marks": [[1e308, 1e308], [-1e308, 0]]})").empty());
}

TEST(MotifFigure, ASignTakesTheFlagsPlace) {
  EXPECT_EQ(figures_of(R"("dragon")").front().reverse, (std::vector<std::uint8_t>{0, 1}));
  const MotifFigure signed_figure = figures_of(R"({"name": "dragon", "sign": "edge"})").front();
  EXPECT_TRUE(signed_figure.reverse.empty());
}

TEST(MotifFigure, FillsItsAreaInOneScale) {
  const std::vector<std::vector<Vec2>> paths = drawn_paths(figures_of(R"("koch")"), "motif");
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_NEAR(paths[0].front().x, 20, 1e-9);
  EXPECT_NEAR(paths[0].back().x, 220, 1e-9);
  EXPECT_NEAR(paths[0][2].x, 120, 1e-9);
  EXPECT_NEAR(paths[0][2].y - paths[0][0].y, 200 * std::sqrt(3.0) / 6, 1e-9);  // to the right of travel: down
  const auto several = drawn_paths(figures_of(R"({"by_level": ["koch", "levy", "minkowski", "fret"]})"), "motif");
  ASSERT_EQ(several.size(), 4U);
  for (const std::vector<Vec2>& path : several) {
    EXPECT_NEAR(distance(path.front(), path.back()), distance(several[0].front(), several[0].back()), 1e-9);
    for (const Vec2 p : path) EXPECT_TRUE(area.grown(1e-9).contains(p));
  }
}

TEST(MotifFigure, HalfArrowsPointTheWayAnEdgeIsBuilt) {
  // Arrow: tail, tip, barb.
  const auto arrows = drawn_paths(figures_of(R"("gosper")"), "directions");
  const auto path = drawn_paths(figures_of(R"("gosper")"), "motif").front();
  ASSERT_EQ(arrows.size(), 7U);
  const std::vector<int> reversed{0, 1, 1, 0, 0, 0, 1};
  for (std::size_t j = 0; j < arrows.size(); ++j) {
    const Vec2 travel = path[j + 1] - path[j];
    EXPECT_EQ(dot(arrows[j][1] - arrows[j][0], travel) < 0, reversed[j] == 1) << j;
    // The barb lies to the right of the arrow: clockwise where y is down.
    EXPECT_GT(cross(arrows[j][1] - arrows[j][0], arrows[j][2] - arrows[j][0]), 0) << j;
  }
  const auto mirrored = drawn_paths(figures_of(R"("hilbert4")"), "directions");
  for (const std::size_t j : {std::size_t{0}, std::size_t{3}}) {
    EXPECT_LT(cross(mirrored[j][1] - mirrored[j][0], mirrored[j][2] - mirrored[j][0]), 0) << j;
  }
  // An edge of no length has no direction.
  EXPECT_EQ(drawn_paths(figures_of(R"({"marks": [[0.5, 0.2], [0.5, 0.2]]})"), "directions").size(), 2U);
}

}  // namespace
}  // namespace burin::curves::two_point
