#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/point_store.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// What every family of the catalogue promises, held for each of them under defaults, extremes and degenerate input.
namespace burin::curves {
namespace {

std::vector<std::string> line_art_cases() {
  const auto over_square = [](const std::string& rest) {
    return "{\"lines\": 200, \"start\": [0, 0, 1, 1], " + rest + "}";
  };
  return {
      R"({})",
      R"({"lines": 1, "segments": 1, "length": 0})",
      R"({"starts": 7, "lines_per_start": 3, "spread": 360, "turn": 3600, "start": {"disc": [0, 0, 2]}})",
      R"({"lines": 20, "start": {"polygon": "square"}})",
      over_square(R"("segments": [1, 40], "places": "even", "flow": "200 * noise(2*x, y) + 5", "follow": 0.5)"),
      over_square(R"("grow": "both", "stretch": "1.2 - t - rand", "heading": 20)"),
      over_square(R"("compose": {"density": "x", "kind": "3 * rand", "smooth": "corners", "shortest": 0.05})"),
      over_square(R"("compose": {"inside": [-0.1, 0, 1, 1], "keep_out": {"disc": [1, 1, 1]}, "meet": "resume"})"),
      over_square(R"("compose": {"smooth": "four-point", "smooth_levels": 2, "spacing": 0.02, "budget": 20})"),
      over_square(R"("compose": {"tone": "0.5 * x", "pen_width": 0.01, "meet": "drop"})"),
  };
}

std::vector<std::string> line_art_boundary_cases() {
  const auto tracks = [](const std::string& rest) {
    return R"({"lines": 90, "from": {"along": "triangle"}, "to": [[3, 3], {"along": "square"}], )" + rest + "}";
  };
  return {
      R"({})",
      R"({"lines": 1, "levels": 0})",
      R"({"levels": 7, "lines": 2, "markers": [0.3], "decay": 0.5})",
      R"({"levels": 3, "markers": [], "from": [0, 0], "to": [1, 1]})",
      R"({"levels": 3, "from": [0, 0], "to": [0, 0], "unit": "absolute"})",
      tracks(R"("lines_per_start": 4, "weights": [0, 1], "pairing": "crossed", "places": "steps")"),
      tracks(R"("pairing": "nearest", "wander": "y", "compose": {"spacing": 0.003, "density": "span < 3"})"),
  };
}

std::vector<std::string> two_point_3d_cases() {
  return {
      R"({})",
      R"({"levels": 0, "base": "square"})",
      R"({"levels": 2, "motif": "terdragon", "base": {"solid": "icosahedron"}, "camera": {"eye": [0, 0, 1]}})",
      R"({"levels": 3, "motif": "dragon", "base": {"knot": [2, 3], "n": 5}, "orient": "reference", "theta": "rand"})",
      R"({"levels": 4, "base": {"points": [[1, 1, 1], [1, 1, 1]]}})",
      R"({"levels": 4, "motif": {"marks": [[0.5, 1]], "beta": "absolute"},
              "base": {"points": [[1, 1, 0], [1, 1, 0], [2, 1, 1]], "closed": true}})",
      R"({"levels": 4, "theta": [{"random": [-1, 3]}], "normalize": false, "sign": "random",
              "motif": {"marks": [[0.5, {"random": [-0.1, 0.1]}]]},
              "camera": {"projection": "perspective", "eye": [5, 5, 5]}})",
      R"({"levels": 3, "theta": "level", "normalize": false, "motif": {"marks": [[1.5, 0]]}})",
      R"({"levels": 3, "theta": [0, 1], "motif": {"marks": [[0.2, 2], [0.8, "level - edge"]]}})",
      R"({"levels": 6, "theta": "marker/2 - level", "motif": {"by_level": [{"marks": [[0.5, 0.1]]},
              {"marks": [[0.3, 0.1], [0.6, 0.1]]}]}, "base": {"points": [[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 1, 1]]}})"};
}

/// Cases of a family, as JSON. A new family adds its own line.
std::vector<std::string> cases_of(std::string_view family) {
  if (family == "text") {
    return {R"({"text": "."})", R"({"text": "Àß\n\n œ", "font": "italic-bold", "align": "center", "line_height": 0})",
            R"({"text": "one\r\nthree", "align": "right", "tracking": -1, "slant": 60, "font": "script"})",
            R"({"text": "||||", "tracking": 100, "line_height": 100, "slant": -60, "font": "gothic"})"};
  }
  if (family == "two-point-3d") return two_point_3d_cases();
  const std::string in_space =
      R"("base": {"knot": [3, 2], "n": 8}, "camera": {"projection": "perspective", "eye": [9, 7, 5], "fov": 20})";
  const std::string open = R"("base": {"points": [[0, 0], [1, 2], [3, 2], [4, 0], [6, 1], [7, 3]]})";
  if (family == "de-rham") {
    return {R"({})",
            R"({"levels": 0})",
            R"({"t": 0.75, "levels": 9})",
            R"({"t": 0.5, "levels": 4, "base": {"points": [[1, 1], [1, 1], [1, 1]], "closed": true}})",
            R"({"t": 0.3, "levels": 5, "base": {"points": [[1, 1], [2, 1]]}})",
            R"({"t": 0.3, "levels": 5, "ends": "clamp", "base": {"points": [[1, 1], [2, 1]]}})",
            R"({"t": 0.4, "ends": "clamp", "levels": 4, )" + open + '}',
            R"({"lambda": -0.125, "levels": 6, "base": {"path": "M0 0h1v1z M3 0h1v1"}})",
            R"({"t": 1.2, "normalize": true, "levels": 5, "base": "triangle"})",
            R"({"t": 1.2, "normalize": true, "levels": 5, )" + in_space + '}',
            R"({"t": 0.3, "levels": 5, "base": {"solid": "octahedron"}})",
            R"({"t": -1e3, "levels": 5})"};
  }
  if (family == "four-point") {
    return {R"({})",
            R"({"levels": 0, )" + open + '}',
            R"({"t": 0.6, "levels": 9})",
            R"({"t": 0.6, "levels": 7, )" + in_space + '}',
            R"({"w": 0.4, "levels": 6, "ends": "reflect", )" + open + '}',
            R"({"t": 0, "levels": 3, "ends": "replicate", )" + open + '}',
            R"({"levels": 4, "base": "segment"})",
            R"({"levels": 4, "base": {"points": [[1, 1], [1, 1]], "closed": true}})",
            R"({"t": 5, "levels": 5, "base": {"path": "M0 0h1v1z M3 0h1v1"}})"};
  }
  if (family == "four-parameter") {
    return {R"({})",
            R"({"levels": 0, "ends": "given", )" + open + '}',
            R"({"lambda": 0.2, "mu": 0.1, "nu": 0.3, "omega": -0.1, "levels": 6, "ends": "given", )" + open + '}',
            R"({"lambda": "1/30", "mu": "1/30", "omega": "1/3", "levels": 8})",
            R"({"lambda": "1/30", "mu": "1/30", "omega": "1/3", "levels": 6, )" + in_space + '}',
            R"({"lambda": 0.125, "mu": 0.125, "omega": 0, "levels": 5, "ends": "reflect", )" + open + '}',
            R"({"levels": 4, "base": "segment"})",
            R"({"levels": 4, "base": {"points": [[1, 1], [1, 1]], "closed": true}})",
            R"({"lambda": -1, "mu": 3, "nu": 2, "omega": -2, "levels": 5, "base": {"path": "M0 0h1v1z M3 0h1v1"}})"};
  }
  if (family == "fractal-interpolation") {
    return {
        R"({"points": [[0, 0], [1, 2], [3, 1]]})",
        R"({"points": [[0, 0], [1, 1e-300], [2, 0]], "levels": 0, "scaling": 0.999999})",
        R"({"points": [[0, 0], [1, 0], [1, 1]], "closed": true, "levels": 4, "scaling": [[0.5, 0.4], -0.7, 0.1]})",
        R"({"points": [[0, 0], [1, 3], [2, 1], [4, 2], [5, 0]], "block": 2, "part": [0.1, 0.7], "plot": "nodes"})",
        R"({"points": [[0, 0], [1, 3], [2, 1], [4, 2]], "plot": "error", "exact": "x^2", "alpha": 0, "beta": 1e12})"};
  }
  if (family == "line-art") return line_art_cases();
  if (family == "line-art-boundary") return line_art_boundary_cases();
  if (family == "line-art-3d") {
    return {R"({})", R"({"lines": 1, "segments": 1, "length": 0, "heading": [1, 0, 0], "turn": 0})",
            R"({"lines": 90, "lines_per_start": 3, "start": {"sphere": [0, 0, 0, 2]}, "turn": 180, "heading": [0, 0, 1],
                "spread": 10, "places": "even"})",
            R"({"lines": 90, "start": {"box": [0, 0, 0, 1, 2, 3]}, "camera": {"projection": "perspective"},
                "compose": {"density": "depth", "kind": "3 * rand", "smooth": "corners", "spacing": 0.02}})"};
  }
  if (family == "line-art-boundary-3d") {
    return {R"({})", R"({"lines": 1, "levels": 0})",
            R"({"levels": 3, "from": [0, 0, 0], "to": [0, 0, 0], "unit": "absolute"})",
            R"({"levels": 5, "lines": 20, "from": {"along": {"knot": [2, 3]}}, "to": {"polygon": "square"},
                "pairing": "nearest", "decay": 0.5, "camera": {"projection": "perspective", "eye": [1, 2, 3]}})"};
  }
  if (family == "svg") return {R"({"file": "drawing.svg"})", R"({"file": "drawing.svg", "parts": "outlines"})"};
  if (family == "shape") {
    return {R"({})",
            R"({"kind": "ring", "r": 30, "inner": 0.9})",
            R"({"kind": "polygon", "n": 3, "turn": 3600})",
            R"({"kind": "star", "n": 10000, "inner": 1e-9})",
            R"({"kind": "rectangle", "width": 1e-6, "corner": 5})",
            R"({"kind": "rectangle", "height": 4, "corner": 0.25})",
            R"({"kind": "path", "d": "M1 2zl3 4M0 0h1v1zm5 5q1 1 2 0"})"};
  }
  EXPECT_EQ(family, "two-point") << "a new family needs its cases here";
  return {
      R"({})",
      R"({"levels": 0})",
      R"({"levels": 3, "motif": "terdragon", "base": "square"})",
      R"({"levels": 4, "base": {"points": [[1, 1], [1, 1]]}})",
      R"({"levels": 4, "motif": {"marks": [[0.5, 1]], "beta": "absolute"}, "base": {"points": [[1, 1], [1, 1], [2, 1]]}})",
      R"({"levels": 3, "motif": {"marks": [[0, 0], [1, 0]]}})",
      R"({"levels": 5, "motif": {"marks": [[{"random": [-2, 3]}, {"random": [-5, 5]}]]}})",
      R"({"levels": 6, "sign": "random", "base": {"shape": "star", "n": 2}})",
      R"({"levels": 4, "motif": "hilbert"})",
      R"({"levels": 0, "motif": "peano"})",
      R"({"levels": 3, "base": "square", "motif": {"name": "koch", "join": [0.5, 3], "sign": "edge"}})"};
}

/// What a family reads from files.
Result<std::string> drawing_file(std::string_view) {
  return std::string(
      "<svg viewBox='0 0 40 30'><path d='M1 2C3 4 5 6 7 1z' stroke='red'/><path d='M5 5h9' stroke='red'/>"
      "<path d='M1 20h9v9M20 20v5' stroke='red' fill='none' stroke-dasharray='2 1'/></svg>");
}

/// Stops the drawing after so many calls.
class StopAfter final : public Decorator {
 public:
  StopAfter(PathSink& next, int calls) : Decorator(next), left_(calls) {}
  Flow begin(const PathHead& head) override { return left_-- <= 0 ? Flow::stop : next().begin(head); }
  Flow points(std::span<const Vec2> points) override { return left_-- <= 0 ? Flow::stop : next().points(points); }
  Flow end() override { return left_-- <= 0 ? Flow::stop : next().end(); }
  bool stopped() const { return left_ < 0; }

 private:
  int left_;
};

TEST(FamilyContract, EveryFamilyKeepsItForEveryCase) {
  for (const Family& family : catalogue()) {
    EXPECT_FALSE(family.summary.empty());
    EXPECT_FALSE(family.source.empty());
    EXPECT_FALSE(family.fields().empty());
    for (const std::string& text : cases_of(family.name)) {
      SCOPED_TRACE(std::string(family.name) + ' ' + text);
      const testing::ReadParams read = testing::read_params(family.name, text, drawing_file);
      ASSERT_TRUE(read.params.has_value()) << problems_text(read.problems);
      for (const std::uint64_t seed : {0ULL, 1ULL, 0xFFFFFFFFFFFFFFFFULL}) {
        const DrawContext context{.seed = seed};
        const Recording first =
            testing::record(family.name, *read.params, context);  // checks call order and finiteness
        const Recording again = testing::record(family.name, *read.params, context);
        EXPECT_EQ(first.all_points(), again.all_points());
        const Forecast forecast = family.forecast(*read.params, context, 1e9);
        EXPECT_EQ(forecast.points, static_cast<double>(first.all_points().size()));
        EXPECT_TRUE(forecast.exact);
        std::vector<Vec2> memory(first.all_points().size());
        PointStore store(memory);
        EXPECT_EQ(family.draw(*read.params, context, store), Flow::go);
        EXPECT_EQ(memory, first.all_points());
        const std::optional<Box2> box = family.bounds(*read.params, context, {});
        ASSERT_TRUE(box.has_value());
        const Box2 drawn = first.bounds();
        const double size = 1.0 + drawn.width() + drawn.height();
        EXPECT_NEAR(box->low.x, drawn.low.x, 1e-12 * size);
        EXPECT_NEAR(box->low.y, drawn.low.y, 1e-12 * size);
        EXPECT_NEAR(box->high.x, drawn.high.x, 1e-12 * size);
        EXPECT_NEAR(box->high.y, drawn.high.y, 1e-12 * size);
        const Vec2 origin{0.75, -2.5};
        const Recording moved = testing::record(family.name, *read.params, {.seed = seed, .origin = origin});
        ASSERT_EQ(moved.all_points().size(), first.all_points().size());
        for (std::size_t i = 0; i < moved.all_points().size(); ++i) {
          EXPECT_LT(distance(moved.all_points()[i] + origin, first.all_points()[i]), 1e-12 * size);
        }
        if (!family.uses_seed(*read.params)) {
          EXPECT_EQ(first.all_points(), testing::record(family.name, *read.params, {.seed = seed + 1}).all_points());
        }
        for (int calls = 0; calls < 3; ++calls) {
          Recorder recorder;
          StopAfter stop(recorder, calls);
          Checked checked(stop);
          const Flow flow = family.draw(*read.params, context, checked);
          EXPECT_EQ(flow == Flow::stop, stop.stopped());
        }
      }
    }
  }
}

/// Whether the points are in the full run, bit for bit and in its order.
bool is_subset(const std::vector<Vec2>& points, const std::vector<Vec2>& full) {
  std::size_t at = 0;
  for (const Vec2 p : points) {
    while (at < full.size() && full[at] != p) ++at;
    if (at++ >= full.size()) return false;
  }
  return true;
}

TEST(FamilyContract, AViewGivesASubsetOfTheFullRun) {
  for (const Family& family : catalogue()) {
    for (const std::string& text : cases_of(family.name)) {
      const testing::ReadParams read = testing::read_params(family.name, text, drawing_file);
      const std::vector<Vec2> full = testing::record(family.name, *read.params).all_points();
      for (std::uint64_t trial = 0; trial < 12; ++trial) {
        DrawContext context;
        context.view.tolerance = std::pow(10.0, -4.0 * uniform(1, trial));
        if (trial % 2 == 1) {
          const Vec2 centre = full[random_bits(2, trial) % full.size()];
          context.view.box = Box2{centre, centre}.grown(0.2 * uniform(3, trial));
        }
        const std::vector<Vec2> seen = testing::record(family.name, *read.params, context).all_points();
        EXPECT_TRUE(is_subset(seen, full)) << family.name << ' ' << text << " trial " << trial;
        const Forecast forecast = family.forecast(*read.params, context, 1e9);
        EXPECT_EQ(forecast.points, static_cast<double>(seen.size())) << family.name << ' ' << text;
      }
    }
  }
}

TEST(FamilyContract, RowsAreDocumentedAndDistinct) {
  for (const Family& family : catalogue()) {
    EXPECT_EQ(find_family(family.name), &family);
    bool has_cost_knob = false;
    for (const params::FieldInfo& field : family.fields()) {
      EXPECT_FALSE(field.doc.empty()) << field.name;
      EXPECT_FALSE(field.type.empty()) << field.name;
      has_cost_knob = has_cost_knob || field.name == family.cost_knob;
    }
    EXPECT_TRUE(has_cost_knob) << family.name;
  }
  EXPECT_EQ(find_family("three-point"), nullptr);
}

}  // namespace
}  // namespace burin::curves
