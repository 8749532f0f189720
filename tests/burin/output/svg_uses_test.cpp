#include <cmath>
#include <sstream>

#include <gtest/gtest.h>

#include <burin/path/recording.hpp>

#include "support/svg_drawing.hpp"

/// Figures in <defs>: what a reader draws of the uses is what would have been drawn as paths.
namespace burin::output {
namespace {

/// A hook and a ring, which no turn or mirror brings onto itself, and a dot; `far` is where the hook ends.
Figure hook(double far = 1.0, Paint paint = Paint::stroke) {
  Recorder recorder;
  const std::vector<test::DrawnPath> paths{{{.paint = paint}, {{{0, 0}, {0.7, 0.1}, {far, 0.6}}}},
                                           {{.paint = paint, .closed = true}, {{{-1, 0}, {0, -0.5}, {0.2, 0.2}}}},
                                           {{.paint = paint}, {{{0.3, 0.3}}}}};
  EXPECT_EQ(test::draw(paths, recorder), Flow::go);
  return Figure(recorder.take());
}

struct Placing {
  Figure figure;
  Affine2 at;
  LayerId layer = 0;
};

std::string svg(const std::vector<Placing>& placings, bool defs, std::size_t layers = 2) {
  StringSink bytes;
  OutputOptions options;
  options.defs = defs;
  const Sheet sheet = test::plain_sheet(layers);
  const auto sink = open_svg(bytes, sheet, options);
  for (const Placing& placing : placings) {
    EXPECT_EQ(sink->place({.layer = placing.layer}, placing.figure, placing.at), Flow::go);
  }
  EXPECT_TRUE(sink->finish().ok());
  return bytes.take();
}

Affine2 transform_of(const std::string& text) {
  std::string numbers = text;
  for (char& c : numbers) c = (c >= '0' && c <= '9') || c == '.' || c == '-' ? c : ' ';
  std::istringstream read(numbers);
  Affine2 m;
  if (text.starts_with("matrix")) read >> m.a >> m.b >> m.c >> m.d;
  read >> m.e >> m.f;
  return m;
}

/// The points of every contour that a reader of SVG draws, use by use and path by path.
std::vector<std::vector<Vec2>> drawn(const std::string& text) {
  std::vector<std::vector<Vec2>> all;
  std::map<std::string, const test::XmlElement*> groups;
  const test::XmlElement root = test::read_xml(text);
  const auto add = [&](const test::XmlElement& path, const Affine2& m) {
    for (const test::ReadContour& contour : test::read_path_data(path.at("d"))) {
      std::vector<Vec2> points;
      for (const Vec2 p : contour.points) points.push_back(m(p));
      if (contour.closed) points.push_back(points.front());
      all.push_back(points);
    }
  };
  for (const test::XmlElement* layer : test::layers_of(root)) {
    for (const test::XmlElement& element : layer->children) {
      if (element.name == "path") add(element, {});
      if (element.name == "defs") groups["#" + element.child("g").at("id")] = &element.child("g");
      if (element.name != "use") continue;
      const test::XmlElement* group = groups.at(element.at("xlink:href"));  // defined before it is used
      for (const test::XmlElement& path : group->children) add(path, transform_of(element.at("transform")));
    }
  }
  return all;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(SvgUses, ShowWhatPathsWould) {
  std::vector<Placing> placings;
  for (int i = 0; i < 40; ++i) {
    const double size = i % 3 == 0 ? 5.0 : 8.5;
    const Affine2 mirror = scaling(size, i % 2 == 0 ? size : -size);
    placings.push_back(
        {hook(), translation({50.0 + 2 * i, 80.0 + i * 0.37}) * rotation_degrees(11.0 * i) * mirror, i < 20 ? 0U : 1U});
  }
  const std::string compact = svg(placings, true);
  const auto shown = drawn(compact);
  const auto flat = drawn(svg(placings, false));
  ASSERT_EQ(shown.size(), flat.size());
  for (std::size_t i = 0; i < flat.size(); ++i) {
    ASSERT_EQ(shown[i].size(), flat[i].size());
    for (std::size_t j = 0; j < flat[i].size(); ++j) EXPECT_LE(distance(shown[i][j], flat[i][j]), 0.0025);
  }
  EXPECT_EQ(count(compact, "<defs>"), 2U);  // one a size: a pen's width must not scale
  EXPECT_EQ(count(compact, "<use "), 40U);
  EXPECT_EQ(count(compact, "stroke-width"), 2U);
}

TEST(SvgUses, AreNotMadeUnlessAsked) {
  const std::string text = svg({{hook(), scaling(5, 5)}}, false);
  EXPECT_EQ(count(text, "<use"), 0U);
  EXPECT_EQ(count(text, "xlink"), 0U);
}

TEST(SvgUses, WhatCannotBeUsedIsDrawn) {
  // Bent, of another paint than its layer, far away.
  const std::string text =
      svg({{hook(), scaling(5, 6)}, {hook(1, Paint::fill_nonzero), scaling(5, 5)}, {hook(), scaling(2e5, 2e5)}}, true);
  EXPECT_EQ(count(text, "<use"), 0U);
  EXPECT_EQ(drawn(text).size(), 9U);
}

TEST(SvgUses, MoreThan64SizesAreDrawn) {
  std::vector<Placing> placings;
  for (int i = 0; i < 100; ++i) placings.push_back({hook(), scaling(1 + 0.1 * i, 1 + 0.1 * i)});
  placings.push_back({hook(), translation({3, 3})});
  placings.push_back({hook(2.0), {}});
  const std::string text = svg(placings, true);
  EXPECT_EQ(count(text, "<defs>"), 64U);
  EXPECT_EQ(count(text, "<use "), 65U);
  EXPECT_EQ(drawn(text).size(), 3U * 102U);
}

TEST(SvgUses, MoreThan200000AreDrawn) {
  StringSink bytes;
  OutputOptions options;
  options.defs = true;
  const Sheet sheet = test::plain_sheet(1);
  const auto sink = open_svg(bytes, sheet, options);
  const Figure figure = hook();
  for (int i = 0; i < 200'002; ++i) {
    ASSERT_EQ(sink->place({}, figure, translation({0.001 * (i % 1000), 5})), Flow::go);
  }
  EXPECT_TRUE(sink->finish().ok());
  EXPECT_EQ(count(bytes.text(), "<use "), 200'000U);
  EXPECT_EQ(count(bytes.text(), "<path "), 3U + 1U);
  EXPECT_GT(count(bytes.text(), std::string(4096, ' ') + '\n'), 4U);  // libxml2 must rest
}

}  // namespace
}  // namespace burin::output
