#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/math.hpp>
#include <burin/passes/crop.hpp>
#include <burin/path/recording.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/plan.hpp>

/// A part of the page blown up: the same picture, as deep as numbers go.
namespace burin::preset {
namespace {

const ReadFile no_files = [](std::string_view) -> Result<std::string> { return Problem{{}, "no files"}; };

Plan plan_of(const std::string& layers) {
  Result<Piece> piece =
      load({"test.toml", "burin = 1\npage = { size = \"200x200mm\", margin = \"10mm\" }\n" + layers}, {}, no_files);
  if (!piece) throw std::runtime_error(problems_text(piece.problems()));
  return *Plan::make(*std::move(piece));
}

Recording run(const Plan& plan, const RunOptions& options) {
  Recorder recorder;
  Checked checked(recorder);
  EXPECT_EQ(plan.run(checked, options), Flow::go);
  return recorder.take();
}

TEST(Window, ShowsThatPartOfThePageBlownUp) {
  const std::string layers = R"(
pens = { ink = { width = "0.4mm" }, red = { color = "red", width = "0.4mm" } }
slots = { a = { symmetry = "d3" } }
[[layer]]
slot = "a"
fill = "ink"
pen = { by = "px", at = [3], of = ["ink", "red"] }
curve = { family = "two-point", base = { points = [[0, 0], [2, 1], [1, 2]], closed = true }, levels = 3 }
[[layer]]
name = "dots"
caps = "butt"
curve = { family = "two-point", motif = { marks = [[{ random = [0.3, 0.7] }, { random = [-1, 1] }]] }, levels = 5 }
)";
  const Plan plan = plan_of(layers);
  const PageWindow window{{90, 120}, 40};
  const Recording blown_up = run(plan, {.window = window});
  // By hand: the plain drawing, mapped, cut where the widest reach of a pen ends.
  Recorder recorder;
  passes::Crop crop(recorder, Box2{{0, 0}, {200, 200}}.grown(0.2 * 1.5));
  Mapped mapped(crop, translation({100, 100}) * scaling(5, 5) * translation({-90, -120}));
  ASSERT_EQ(plan.run(mapped, {}), Flow::go);
  const Recording& expected = recorder.recording();
  ASSERT_GT(expected.all_points().size(), 150U);
  ASSERT_EQ(blown_up.all_points().size(), expected.all_points().size());
  ASSERT_EQ(blown_up.paths().size(), expected.paths().size());
  for (std::size_t i = 0; i < expected.all_points().size(); ++i) {
    EXPECT_NEAR(blown_up.all_points()[i].x, expected.all_points()[i].x, 1e-9);
    EXPECT_NEAR(blown_up.all_points()[i].y, expected.all_points()[i].y, 1e-9);
  }
  for (std::size_t i = 0; i < expected.paths().size(); ++i)
    EXPECT_EQ(blown_up.paths()[i].head, expected.paths()[i].head);
}

const char* const koch = R"(
slots = { a = { frame = [0, -1, 1, 0] } }
[[layer]]
slot = "a"
curve = { family = "two-point", levels = 1000 }
)";

/// The page place of the vertex a third along Koch's curve, a limit point: (5 - i sqrt(3)) / 14.
Vec2 third_of_koch(const Plan& plan) {
  const Box2 box = run(plan, {.tolerance_mm = 1.0}).bounds();
  const double mm_per_unit = box.width();
  return box.low + mm_per_unit * Vec2{5.0 / 14.0, std::sqrt(3.0) / 14.0};
}

TEST(Window, ZoomsToTheTwelfthPowerOfTenWithoutJitter) {
  const Plan plan = plan_of(koch);
  const Vec2 center = third_of_koch(plan);
  double points_of_the_page = 0.0;
  for (const double zoom : {1.0, 1e3, 1e6, 1e9, 1e12}) {
    const RunOptions options{.tolerance_mm = 0.1, .window = PageWindow{center, 200.0 / zoom}};
    const double forecast = plan.forecast(options, 1e7).points;
    if (zoom == 1.0) points_of_the_page = forecast;
    EXPECT_LE(forecast, 6.0 * points_of_the_page) << zoom;
    const Recording shown = run(plan, options);
    std::size_t edges = 0;
    for (const Recording::Path& path : shown.paths()) {
      const auto points = shown.points(shown.contours(path).front());
      // All but the first and the last edge, which are cut: of one length, and turning by multiples of 60 degrees.
      for (std::size_t i = 2; i + 2 < points.size(); ++i) {
        const Vec2 d = points[i] - points[i - 1];
        const Vec2 next = points[i + 1] - points[i];
        const double turn = math::atan2(cross(d, next), dot(d, next)) * 180.0 / math::pi;
        EXPECT_NEAR(turn, 60.0 * std::round(turn / 60.0), 1e-3) << zoom;
        EXPECT_NEAR(length(next) / length(d), 1.0, 1e-4) << zoom;
        ++edges;
      }
    }
    EXPECT_GT(edges, 100U) << zoom;
  }
}

TEST(Window, OutputInModelUnitsHasNone) {
  const Plan plan = plan_of("[[layer]]\ncurve = { family = \"two-point\", levels = 2 }\n");
  const RunOptions plain{.space = Space::model};
  RunOptions windowed = plain;
  windowed.window = PageWindow{{100, 100}, 1};
  EXPECT_EQ(run(plan, windowed).all_points(), run(plan, plain).all_points());
}

}  // namespace
}  // namespace burin::preset
