#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>
#include <burin/primitives/placing.hpp>

#include "support/json_value.hpp"

/// Curves with figures along them, in a line each.
namespace burin::primitives {

/// A figure of one path.
inline std::shared_ptr<const Figure> figure(const std::vector<Vec2>& points, bool closed = true) {
  Recorder recorder;
  EXPECT_EQ(recorder.begin({.closed = closed}), Flow::go);
  EXPECT_EQ(recorder.points(points), Flow::go);
  EXPECT_EQ(recorder.end(), Flow::go);
  return std::make_shared<const Figure>(recorder.take());
}

/// From the anchor one unit along x: what it becomes tells place, turn and scale. The second point tells the mirror.
inline std::shared_ptr<const Figure> arrow() {
  return figure({{0, 0}, {1, 0}, {0, 1}}, false);
}

/// Reads a spec from JSON, and what is wrong with it.
inline PlacingSpec read_spec(const std::string& json, Problems& problems) {
  params::ReadContext context{
      .problems = problems,
      .evaluate = [](std::string_view text, const Where& where) { return expr::evaluate_constant(text, where); },
      .defined = {},
      .read_file = {}};
  PlacingSpec read;
  params::ValueType<PlacingSpec>::read(testing::value_from_json(nlohmann::json::parse(json)), read, context);
  return read;
}

/// Fails the test on problems.
inline PlacingSpec spec(const std::string& json) {
  Problems problems;
  PlacingSpec read = read_spec(json, problems);
  EXPECT_TRUE(problems.empty()) << problems_text(problems);
  return read;
}

/// What is wrong with such a spec.
inline std::string complaint(const std::string& json) {
  Problems problems;
  read_spec(json, problems);
  return problems.empty() ? "" : problems.front().message;
}

/// A figure that was placed.
struct Placed {
  const Figure* figure = nullptr;
  Affine2 at;
  std::uint16_t level = 0;

  Vec2 anchor() const { return at({}); }
  Vec2 direction() const { return at.linear({1, 0}); }
};

/// Notes what is placed.
class PlacedSink final : public PathSink {
 public:
  Flow begin(const PathHead&) override { return unexpected(); }
  Flow points(std::span<const Vec2>) override { return unexpected(); }
  Flow contour() override { return unexpected(); }
  Flow end() override { return unexpected(); }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override {
    placed.push_back({&figure, at, head.level});
    return Flow::go;
  }

  std::vector<Placed> placed;

 private:
  static Flow unexpected() {
    ADD_FAILURE() << "a placing draws no curve";
    return Flow::stop;
  }
};

struct Line {
  std::vector<Vec2> points;
  bool closed = false;
  std::uint16_t level = 0;
};

/// What a spec puts along lines, which come in two spans each. As many arrows as the spec names figures.
inline std::vector<Placed> place_along(const PlacingSpec& how, const std::vector<Line>& lines,
                                       const Setting& setting = {}, std::uint64_t retained_every = 0,
                                       const PenFilter& filter = {}) {
  PlacedSink sink;
  Figures figures;
  for (const std::string& name : how.use.of) figures.push_back(name == no_figure ? nullptr : arrow());
  Placing placing(sink, how, figures, setting, filter);
  placing.begin_level(retained_every);
  for (const Line& line : lines) {
    EXPECT_EQ(placing.begin({.closed = line.closed, .level = line.level}), Flow::go);
    const std::size_t half = (line.points.size() + 1) / 2;
    EXPECT_EQ(placing.points(std::span(line.points).first(half)), Flow::go);
    if (half < line.points.size()) {
      EXPECT_EQ(placing.points(std::span(line.points).subspan(half)), Flow::go);
    }
    EXPECT_EQ(placing.end(), Flow::go);
  }
  for (Placed& placed : sink.placed) placed.figure = nullptr;  // gone
  return sink.placed;
}

inline std::vector<Placed> place_along(const std::string& json, const std::vector<Vec2>& points, bool closed = false) {
  return place_along(spec(json), {{points, closed}});
}

}  // namespace burin::primitives
