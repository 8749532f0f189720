#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/path/path_sink.hpp>
#include <burin/preset/enlargement.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/plan.hpp>

/// A sheet scaled as a whole: like a photograph of it, to any page.
namespace burin::preset {
namespace {

Page page_of(double width_mm, double height_mm) {
  Page page;
  page.width_mm = width_mm;
  page.height_mm = height_mm;
  page.bleed_mm = 3.0;
  return page;
}

TEST(Enlargement, KeepsTheShapeOfThePageAndTheSideThatDecides) {
  const Enlargement poster = enlargement(page_of(300, 400), {594, 841});
  EXPECT_EQ(poster.factor, 1.98);
  EXPECT_EQ(poster.page.width_mm, 594.0);
  EXPECT_DOUBLE_EQ(poster.page.height_mm, 792.0);
  EXPECT_DOUBLE_EQ(poster.page.bleed_mm, 3 * 1.98);
  EXPECT_NEAR(poster.new_from_page({300, 400}).y, 792.0, 1e-9);
  EXPECT_EQ(poster.new_from_page({0, 0}), Vec2{});
}

TEST(Enlargement, PapersOfOneSeriesBecomeEachOther) {
  // 594 / 210 and 841 / 297 differ: the sides are whole millimetres.
  const Enlargement a1 = enlargement(page_of(210, 297), {594, 841});
  EXPECT_EQ(a1.page.width_mm, 594.0);
  EXPECT_EQ(a1.page.height_mm, 841.0);
  EXPECT_NEAR(a1.new_from_page({105, 148.5}).x, 297.0, 1e-9);
  EXPECT_NEAR(a1.new_from_page({105, 148.5}).y, 420.5, 1e-9);
}

TEST(Enlargement, TurnsThePaperToThePieceAndReducesToo) {
  const Enlargement wide = enlargement(page_of(297, 210), {594, 841});
  EXPECT_EQ(wide.page.width_mm, 841.0);
  EXPECT_EQ(wide.page.height_mm, 594.0);
  const Enlargement card = enlargement(page_of(400, 400), {105, 148});
  EXPECT_EQ(card.page.width_mm, 105.0);
  EXPECT_EQ(card.page.height_mm, 105.0);
  EXPECT_LT(card.factor, 1.0);
  const Enlargement same = enlargement(page_of(210, 297), {210, 297});
  EXPECT_EQ(same.factor, 1.0);
  EXPECT_EQ(same.new_from_page, Affine2{});
}

constexpr const char* text =
    "burin = 1\npage = { size = \"100x50mm\", margin = \"10mm\", bleed = \"2mm\" }\n"
    "[pens]\na = { color = \"black\", width = \"0.5mm\" }\nb = { color = \"red\", width = \"1mm\" }\n"
    "[[layer]]\ndashes = [\"3mm\", \"1mm\"]\npen = { by = \"px\", at = [0], of = [\"a\", \"b\"] }\n"
    "curve = { family = \"two-point\", levels = 4 }\n";

Plan plan_with(const Overrides& overrides) {
  const ReadFile no_files = [](std::string_view) -> Result<std::string> { return Problem{{}, "no files"}; };
  Result<Piece> piece = load({"test.toml", text}, overrides, no_files);
  if (!piece) throw std::runtime_error(problems_text(piece.problems()));
  Result<Plan> plan = Plan::make(*std::move(piece));
  if (!plan) throw std::runtime_error(problems_text(plan.problems()));
  return *std::move(plan);
}

/// Keeps every point.
class Points final : public PathSink {
 public:
  Flow begin(const PathHead&) override { return Flow::go; }
  Flow points(std::span<const Vec2> points) override {
    all.insert(all.end(), points.begin(), points.end());
    return Flow::go;
  }
  Flow contour() override { return Flow::go; }
  Flow end() override { return Flow::go; }

  std::vector<Vec2> all;
};

std::vector<Vec2> points_of(const Plan& plan, const RunOptions& options) {
  Points points;
  EXPECT_EQ(plan.run(points, options), Flow::go);
  return points.all;
}

TEST(Enlargement, ScalesPointsPensAndDashesAlike) {
  const Plan plain = plan_with({});
  Overrides overrides;
  overrides.enlarge = "50x25cm";
  const Plan large = plan_with(overrides);
  EXPECT_EQ(large.sheet().page.width_mm, 500.0);
  EXPECT_EQ(large.sheet().page.height_mm, 250.0);
  EXPECT_EQ(large.sheet().page.bleed_mm, 10.0);
  EXPECT_EQ(large.sheet().pens[1].width_mm, 5.0);
  EXPECT_EQ(large.sheet().layers[0].dashes_mm, (std::vector<double>{15.0, 5.0}));
  // Bands look at millimetres of the planned page, so the same points are in the same pens.
  const std::vector<Vec2> small_points = points_of(plain, {});
  const std::vector<Vec2> large_points = points_of(large, {});
  ASSERT_EQ(small_points.size(), large_points.size());
  for (std::size_t i = 0; i < small_points.size(); ++i) {
    EXPECT_NEAR(large_points[i].x, 5 * small_points[i].x, 1e-9);
    EXPECT_NEAR(large_points[i].y, 5 * small_points[i].y, 1e-9);
  }
}

TEST(Enlargement, ShowsWhatALargerDrawingCanShow) {
  Overrides overrides;
  overrides.keys = {{"layer.1.curve.levels", "12"}};
  RunOptions coarse;
  coarse.tolerance_mm = 0.5;
  const Plan plain = plan_with(overrides);
  overrides.enlarge = "50x25cm";
  const Plan large = plan_with(overrides);
  RunOptions fine = coarse;
  fine.tolerance_mm = 0.1;
  EXPECT_GT(points_of(large, coarse).size(), points_of(plain, coarse).size());
  EXPECT_EQ(points_of(large, coarse).size(), points_of(plain, fine).size());
  EXPECT_EQ(large.forecast(coarse, 1e9).points, plain.forecast(fine, 1e9).points);
  // Model units are not enlarged.
  RunOptions model;
  model.space = Space::model;
  EXPECT_EQ(points_of(large, model), points_of(plain, model));
}

}  // namespace
}  // namespace burin::preset
