#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

/// What every family of the catalogue promises, held for each of them under defaults, extremes and degenerate input.
namespace burin::curves {
namespace {

/// Cases of a family, as JSON. A new family adds its own line.
std::vector<std::string> cases_of(std::string_view family) {
  if (family == "text") {
    return {R"({"text": "."})", R"({"text": "Àß\n\n œ", "font": "italic-bold", "align": "center", "line_height": 0})",
            R"({"text": "one\r\nthree", "align": "right", "tracking": -1, "slant": 60, "font": "script"})",
            R"({"text": "||||", "tracking": 100, "line_height": 100, "slant": -60, "font": "gothic"})"};
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
      const testing::ReadParams read = testing::read_params(family.name, text);
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
