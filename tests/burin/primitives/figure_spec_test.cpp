#include <string>

#include <gtest/gtest.h>

#include <burin/primitives/figure_spec.hpp>

namespace burin::primitives {
namespace {

using params::Table;
using params::Value;

const Where here{"p.toml", 7, 9};

Value text(const std::string& value) {
  return {here, value};
}
Value pair(double a, double b) {
  return {here, params::Array{{here, a}, {here, b}}};
}
Value whole_pair(std::int64_t a, std::int64_t b) {
  return {here, params::Array{{here, a}, {here, b}}};
}

struct Read {
  std::optional<Primitive> figure;
  std::string problems;
};

/// Reads `name` where [define] holds `table` under "mine".
Read read(const std::string& name, const std::vector<params::Entry>& table = {}) {
  Problems problems;
  const Value defined{here, Table{table}};
  params::ReadContext context{
      .problems = problems,
      .evaluate = {},
      .defined = [&](std::string_view wanted) -> const Value* { return wanted == "mine" ? &defined : nullptr; },
      .read_file = [](std::string_view file) -> Result<std::string> {
        if (file == "bar.svg") return std::string("<svg><path d='M0 0h9' stroke='red'/><text>x</text></svg>");
        return Problem{{std::string(file)}, "cannot be read: no such file"};
      }};
  Read result{read_figure(name, here, context), {}};
  result.problems = problems_text(problems);
  EXPECT_EQ(result.figure.has_value(), problems.empty());
  return result;
}

Box2 box_of(const Read& read) {
  return read.figure ? read.figure->figure->drawing().bounds() : Box2{};
}

TEST(FigureSpec, PathDataInTheNameOrInATable) {
  EXPECT_EQ(box_of(read("M0 0L4 2")), (Box2{{-0.5, -0.25}, {0.5, 0.25}}));
  const Read anchored = read("mine", {{"d", here, text("M0 0L0 -4")}, {"anchor", here, pair(0, 0)}});
  EXPECT_EQ(box_of(anchored), (Box2{{0.0, 0.0}, {0.0, 1.0}})) << anchored.problems;
  EXPECT_EQ(anchored.figure->name, "mine");
  const Read turned =
      read("mine", {{"d", here, text("M0 0L4 0")}, {"anchor", here, pair(0, 0)}, {"up", here, pair(1, 0)}});
  EXPECT_NEAR(box_of(turned).high.y, 1.0, 1e-12);
  EXPECT_NEAR(box_of(turned).high.x, 0.0, 1e-12);
  const Read filled = read("mine", {{"d", here, text("M0 0h4v4")}, {"fill", here, {here, true}}});
  EXPECT_EQ(filled.figure->figure->drawing().paths()[0].head.paint, Paint::fill_nonzero);
}

TEST(FigureSpec, Pixels) {
  const Read pixels = read("mine", {{"pixels", here, text("##\n##")}, {"anchor_pixel", here, whole_pair(0, 1)}});
  EXPECT_EQ(box_of(pixels), (Box2{{-0.25, -0.25}, {0.75, 0.75}})) << pixels.problems;
  EXPECT_EQ(pixels.figure->figure->drawing().paths()[0].head.paint, Paint::fill_nonzero);
  const Read lines = read("mine", {{"pixels", here, text("#")}, {"fill", here, {here, false}}});
  EXPECT_EQ(lines.figure->figure->drawing().paths()[0].head.paint, Paint::stroke);
}

TEST(FigureSpec, FilesAndShippedFigures) {
  EXPECT_TRUE(read("leaf").figure.has_value());
  EXPECT_NE(read("bar.svg").problems.find("text is not drawn"), std::string::npos);
  EXPECT_TRUE(read("mine", {{"file", here, text("bar.svg")}, {"partial", here, {here, true}}}).figure.has_value());
  EXPECT_NE(read("gone.png").problems.find("no such file"), std::string::npos);
}

TEST(FigureSpec, WhatIsWrongIsToldWithItsPlace) {
  const auto complaint = [](const std::vector<params::Entry>& table) { return read("mine", table).problems; };
  EXPECT_NE(complaint({}).find("p.toml:7:9: error: figure 'mine': a figure needs exactly one of"), std::string::npos);
  EXPECT_NE(complaint({{"d", here, text("M0 0")}}).find("draws nothing"), std::string::npos);
  EXPECT_NE(complaint({{"d", here, text("L0")}}).find("must begin with M"), std::string::npos);
  EXPECT_NE(complaint({{"d", here, text("M0 0h1")}, {"up", here, pair(0, 0)}}).find("no direction"), std::string::npos);
  EXPECT_NE(complaint({{"d", here, text("M0 0h1")}, {"anchor_pixel", here, whole_pair(0, 0)}}).find("is for pixels"),
            std::string::npos);
  EXPECT_NE(complaint({{"file", here, text("bar.svg")}, {"anchor", here, pair(0, 0)}}).find("labelled"),
            std::string::npos);
  EXPECT_NE(complaint({{"pixels", here, text("..")}}).find("no pixel"), std::string::npos);
  EXPECT_NE(complaint({{"pixls", here, text("#")}}).find("did you mean 'pixels'"), std::string::npos);
  EXPECT_NE(
      complaint({{"pixels", here, text("#")}, {"anchor_pixel", here, {here, params::Array{{here, std::int64_t{1}}}}}})
          .find("a pair of numbers, not 1"),
      std::string::npos);
  EXPECT_NE(read("leav").problems.find("p.toml:7:9: error: no figure is called 'leav'; did you mean 'leaf'?"),
            std::string::npos);
}

}  // namespace
}  // namespace burin::primitives
