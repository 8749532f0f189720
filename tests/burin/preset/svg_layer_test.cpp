#include <string>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/plan.hpp>

/// The sources `svg` and `shape` of a layer.
namespace burin::preset {
namespace {

constexpr const char* logo =
    "<svg width='40mm' height='20mm' viewBox='0 0 40 20'>"
    "<path d='M0 0H40V20H0Z M10 5V15H30V5Z' fill-rule='evenodd'/><path d='M15 10H25' stroke='red'/></svg>";

Result<std::string> files(std::string_view name) {
  if (name == "logo.svg") return std::string(logo);
  if (name == "text.svg") return std::string("<svg>\n<text>x</text><rect width='9' height='9'/></svg>");
  return Problem{{std::string(name)}, "cannot be read: no such file"};
}

Result<Piece> load_layer(const std::string& layer) {
  return load({"p.toml",
               "burin = 1\npage = { size = \"100x100mm\", margin = \"10mm\" }\n[pens]\nink = { color = \"black\", "
               "width = \"1mm\" }\nred = { color = \"red\" }\n[slots]\ntrue = { scale = \"1mm\" }\n[[layer]]\n" +
                   layer},
              {}, files);
}

std::string complaint(const std::string& layer) {
  const Result<Piece> piece = load_layer(layer);
  return piece ? "" : problems_text(piece.problems());
}

Recording drawn(const std::string& layer) {
  Result<Piece> piece = load_layer(layer);
  EXPECT_TRUE(piece.ok()) << problems_text(piece.problems());
  if (!piece) return {};
  const Result<Plan> plan = Plan::make(*std::move(piece));
  EXPECT_TRUE(plan.ok());
  Recorder recorder;
  Checked checked(recorder);
  EXPECT_EQ(plan->run(checked, {}), Flow::go);
  return recorder.take();
}

std::vector<Paint> paints(const Recording& recording) {
  std::vector<Paint> all;
  for (const Recording::Path& path : recording.paths()) all.push_back(path.head.paint);
  return all;
}

void expect_box(const Recording& recording, Box2 box) {
  EXPECT_NEAR(recording.bounds().low.x, box.low.x, 1e-9);
  EXPECT_NEAR(recording.bounds().low.y, box.low.y, 1e-9);
  EXPECT_NEAR(recording.bounds().high.x, box.high.x, 1e-9);
  EXPECT_NEAR(recording.bounds().high.y, box.high.y, 1e-9);
}

TEST(SvgLayer, FitsItsSlotAndPaintsItself) {
  const Recording recording = drawn("svg = \"logo.svg\"");
  expect_box(recording, {{10.5, 30.25}, {89.5, 69.75}});
  EXPECT_EQ(paints(recording), (std::vector{Paint::fill_evenodd, Paint::stroke}));
  EXPECT_EQ(recording.contours(recording.paths()[0]).size(), 2U);
}

TEST(SvgLayer, AUnitIsAMillimetre) {
  expect_box(drawn("svg = \"logo.svg\"\nslot = \"true\""), {{30.0, 40.0}, {70.0, 60.0}});
}

TEST(SvgLayer, Parts) {
  EXPECT_EQ(paints(drawn("svg = { file = \"logo.svg\", parts = \"strokes\" }")), (std::vector{Paint::stroke}));
  EXPECT_EQ(paints(drawn("svg = { file = \"logo.svg\", parts = \"fills\" }")), (std::vector{Paint::fill_evenodd}));
  const Recording outlines = drawn("svg = { file = \"logo.svg\", parts = \"outlines\" }\nfill = \"red\"");
  EXPECT_EQ(paints(outlines), (std::vector{Paint::fill_nonzero, Paint::fill_nonzero, Paint::stroke, Paint::stroke}));
}

TEST(SvgLayer, WhatIsWrongIsTold) {
  EXPECT_NE(complaint("svg = \"gone.svg\"").find("p.toml:9:8: error: 'file': 'gone.svg' cannot be read"),
            std::string::npos)
      << complaint("svg = \"gone.svg\"");
  EXPECT_NE(complaint("svg = \"text.svg\"").find("text.svg:2:2: error: <text>: text is not drawn"), std::string::npos)
      << complaint("svg = \"text.svg\"");
  EXPECT_NE(complaint("svg = \"text.svg\"").find("partial = true"), std::string::npos);
  EXPECT_EQ(complaint("svg = { file = \"text.svg\", partial = true }"), "");
  EXPECT_NE(
      complaint("svg = { file = \"text.svg\", partial = true, parts = \"strokes\" }").find("none of these 'parts'"),
      std::string::npos);
  EXPECT_NE(complaint("svg = \"logo.svg\"\nfill = \"red\"").find("an svg fills itself"), std::string::npos);
  EXPECT_NE(complaint("svg = {}").find("an svg needs 'file'"), std::string::npos);
  EXPECT_NE(complaint("svg = 3").find("the name of an SVG file"), std::string::npos);
  EXPECT_NE(complaint("svg = \"logo.svg\"\ntext = \"a\"").find("a 'text' and a 'svg'"), std::string::npos);
}

TEST(ShapeLayer, KindsFitTheirSlot) {
  expect_box(drawn("shape = \"disc\""), {{10.5, 10.5}, {89.5, 89.5}});
  expect_box(drawn("shape = { kind = \"rectangle\", width = 4, height = 2, corner = 0.5 }"),
             {{10.5, 30.25}, {89.5, 69.75}});
  const Recording ring = drawn("shape = { kind = \"ring\", inner = 0.5 }\nfill = \"red\"\nstroke = \"none\"");
  ASSERT_EQ(ring.paths().size(), 1U);
  EXPECT_EQ(ring.contours(ring.paths()[0]).size(), 2U);
  EXPECT_EQ(drawn("shape = \"star\"").all_points().size(), 10U);
  EXPECT_EQ(drawn("shape = { kind = \"polygon\", n = 7 }").all_points().size(), 7U);
  expect_box(drawn("shape = { kind = \"path\", d = \"M0 0h2v-1\" }\nslot = \"true\""), {{49.0, 49.5}, {51.0, 50.5}});
}

TEST(ShapeLayer, WhatIsWrongIsTold) {
  EXPECT_NE(complaint("shape = \"disk\"").find("did you mean 'disc'"), std::string::npos);
  EXPECT_NE(complaint("shape = \"path\"").find("a path needs 'd'"), std::string::npos);
  EXPECT_NE(complaint("shape = { d = \"M0 0h1\" }").find("'d' is for kind = \"path\""), std::string::npos);
  EXPECT_NE(complaint("shape = { kind = \"path\", d = \"M0 0\" }").find("draws no line"), std::string::npos);
  EXPECT_NE(complaint("shape = { kind = \"path\", d = \"M0 0x\" }").find("p.toml:9:"), std::string::npos);
}

}  // namespace
}  // namespace burin::preset
