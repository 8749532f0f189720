#include <cmath>
#include <fstream>
#include <sstream>

#include <burin/base/math.hpp>
#include <burin/preset/images.hpp>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

/// 3 x 2 pixels: black, grey 51, white above; white, black, transparent black below.
constexpr unsigned char png[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
                                 0x44, 0x52, 0x00, 0x00, 0x00, 0x03, 0x00, 0x00, 0x00, 0x02, 0x08, 0x06, 0x00, 0x00,
                                 0x00, 0x9d, 0x74, 0x66, 0x1a, 0x00, 0x00, 0x00, 0x19, 0x49, 0x44, 0x41, 0x54, 0x78,
                                 0xda, 0x63, 0x60, 0x60, 0x60, 0xf8, 0x6f, 0x6c, 0x6c, 0xfc, 0x1f, 0x04, 0x18, 0xc0,
                                 0x04, 0x50, 0x00, 0x88, 0x19, 0x00, 0xa0, 0x79, 0x0b, 0x8f, 0xf4, 0xcd, 0x0e, 0xb4,
                                 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

const ReadFile files = [](std::string_view name) -> Result<std::string> {
  if (name == "dots.png") return std::string(reinterpret_cast<const char*>(png), sizeof png);
  if (name == "text.png") return std::string("no picture");
  return Problem{{}, "no file '" + std::string(name) + "'"};
};

std::string preset(const std::string& image, const std::string& layer) {
  return "burin = 1\npage = { size = \"100x100mm\", margin = \"10mm\" }\npens = { ink = {}, red = {} }\nimages.face "
         "= " +
         image + "\n" + std::string(one_layer) + layer + "\n";
}

/// The value at u, v of the image over a slot.
double value(ImageFit fit, double slot_width, double slot_height, double u, double v) {
  auto grey = std::make_shared<GreyImage>(GreyImage{3, 2, {0.0F, 0.2F, 1.0F, 1.0F, 0.0F, 1.0F}});
  const SlotFrame slot{{0, 0}, slot_width, slot_height};
  const std::vector<PlaneFunction> functions = image_functions({{"face", fit, grey}}, slot);
  return (*functions.front().value)(u, v);
}

TEST(Images, PixelsLieUprightOverTheSlot) {
  const auto stretched = [](double u, double v) { return value(ImageFit::stretch, 10, 77, u, v); };
  EXPECT_NEAR(stretched(1.0 / 6, 0.75), 0.0, 1e-6);
  EXPECT_NEAR(stretched(0.5, 0.75), 0.2, 1e-6);
  EXPECT_NEAR(stretched(5.0 / 6, 0.25), 1.0, 1e-6);
  EXPECT_NEAR(stretched(0.5, 0.5), 0.1, 1e-6);       // between two rows
  EXPECT_NEAR(stretched(1.0 / 3, 0.75), 0.1, 1e-6);  // between two columns
  EXPECT_NEAR(stretched(-9, 9), 0.0, 1e-6);          // beyond the border, as on it
  EXPECT_TRUE(std::isnan(stretched(NAN, 0)));
}

TEST(Images, CoverCutsAndContainLeavesWhite) {
  // A square slot of a picture 3:2: cover shows its middle two thirds, contain leaves a sixth above and below.
  EXPECT_NEAR(value(ImageFit::cover, 50, 50, 0.5, 0.75), 0.2, 1e-6);
  EXPECT_NEAR(value(ImageFit::cover, 50, 50, 0.0, 0.75), 0.0, 1e-6);
  EXPECT_NEAR(value(ImageFit::cover, 50, 50, 0.25, 0.75), 0.1, 1e-6);
  EXPECT_NEAR(value(ImageFit::contain, 50, 50, 1.0 / 6, 0.5 + 1.0 / 6), 0.0, 1e-6);
  EXPECT_EQ(value(ImageFit::contain, 50, 50, 0.5, 0.9), 1.0);
  EXPECT_NEAR(value(ImageFit::contain, 100, 20, 0.5, 0.75), 0.2, 1e-6);
  EXPECT_EQ(value(ImageFit::contain, 100, 20, 0.1, 0.75), 1.0);
}

TEST(Images, FlowRunsAlongWhatHasOneBrightness) {
  // A ramp over the direction `deg`, brighter that way, in a slot twice as wide as the picture is seen.
  for (const double deg : {0.0, 30.0, 90.0, 135.0, 200.0, 300.0}) {
    auto ramp = std::make_shared<GreyImage>(GreyImage{400, 200, std::vector<float>(80'000)});
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 400; ++x) {
        const double along = (x - 200) * math::cos(deg * math::pi / 180) - (y - 100) * math::sin(deg * math::pi / 180);
        ramp->values[static_cast<std::size_t>(400 * y + x)] = static_cast<float>(0.5 + 0.002 * along);
      }
    }
    const std::vector<PlaneFunction> functions = image_functions({{"face", ImageFit::cover, ramp}}, {{0, 0}, 90, 90});
    ASSERT_EQ(functions[1].name, "face_flow");
    const double flow = (*functions[1].value)(0.4, 0.6);
    EXPECT_NEAR(std::remainder(flow - (deg + 90), 360), 0.0, 1e-2) << deg;
  }
}

TEST(Images, LineArtAsksThem) {
  const Result<Piece> piece = load_text(
      "burin = 1\nimages.face = { file = \"dots.png\" }\n[[layer]]\ncurve = { family = \"line-art\", lines = 50, flow "
      "= "
      "\"face_flow(x, y)\", compose = { density = \"1 - face(x, y)\" } }\n",
      {}, files);
  EXPECT_TRUE(piece.ok()) << problems_text(piece.problems());
}

TEST(Images, AFileIsReadAndAskedInExpressions) {
  const Result<Piece> piece = load_text(preset("{ file = \"dots.png\", fit = \"stretch\" }",
                                               "pen = { by = \"face(u, v)\", at = [0.5], of = [\"ink\", \"red\"] }"),
                                        {}, files);
  ASSERT_TRUE(piece.ok()) << problems_text(piece.problems());
  const PenChoice& pen = piece->layers[0].style.pen;
  const auto band = [&](double u, double v) {
    primitives::PositionValues values{};
    values[primitives::position_variable("u")] = u;
    values[primitives::position_variable("v")] = v;
    return pen.pick(values);
  };
  EXPECT_EQ(band(0.1, 0.9), 0U);
  EXPECT_EQ(band(0.9, 0.9), 1U);
  EXPECT_EQ(band(0.1, 0.1), 1U);
  EXPECT_EQ(band(0.5, 0.1), 0U);
  EXPECT_EQ(band(0.9, 0.1), 1U);  // transparent: the paper
  ASSERT_EQ(piece->data.size(), 1U);
  EXPECT_EQ(piece->data[0].name, "dots.png");
}

TEST(Images, GammaAndBlurChangeWhatIsRead) {
  const auto brightness = [](const std::string& more, double u, double v) {
    const Result<Piece> piece = load_text(preset("{ file = \"dots.png\", fit = \"stretch\"" + more + " }",
                                                 "primitives = { use = \"circle\", scale = \"face(u, v)\" }"),
                                          {}, files);
    EXPECT_TRUE(piece.ok()) << problems_text(piece.problems());
    primitives::PositionValues values{};
    values[primitives::position_variable("u")] = u;
    values[primitives::position_variable("v")] = v;
    return piece->layers[0].style.primitives->scale.of[0].value(values);
  };
  EXPECT_NEAR(brightness("", 0.5, 0.75), 0.2, 1e-6);
  EXPECT_NEAR(brightness(", gamma = 2", 0.5, 0.75), 0.04, 1e-6);
  // Softened over the whole picture, hardly anything is left of its dots.
  EXPECT_LT(std::abs(brightness(", blur = 100", 0.9, 0.75) - brightness(", blur = 100", 0.5, 0.25)), 0.1);
}

TEST(Images, SaysWhatIsWrong) {
  const auto complaint = [](const std::string& image, const std::string& layer = "") {
    const Result<Piece> piece = load_text(preset(image, layer), {}, files);
    return piece ? "" : piece.problems().front().message;
  };
  EXPECT_EQ(complaint("{ fit = \"cover\" }"), "an image needs a 'file': { file = \"face.png\" }");
  EXPECT_EQ(complaint("3"), "image 'face' is a table in braces, not a whole number");
  EXPECT_EQ(complaint("{ file = \"gone.png\" }"), "no file 'gone.png'");
  EXPECT_NE(complaint("{ file = \"text.png\" }"), "");
  EXPECT_EQ(complaint("{ file = \"dots.png\", gamma = 0 }"), "'gamma' = 0 is outside (0, 100]");
  EXPECT_EQ(complaint("{ file = \"dots.png\" }", "primitives = { use = \"circle\", scale = \"face(u)\" }"),
            "'primitives': 'scale': 'face' takes 2 arguments, not 1");
  EXPECT_EQ(complaint("{ file = \"dots.png\" }", "primitives = { use = \"circle\", scale = \"fase(u, v)\" }"),
            "'primitives': 'scale': unknown function 'fase'; did you mean 'face'?");
  EXPECT_NE(complaint("{ file = \"dots.png\" }\nimages.phi = { file = \"dots.png\" }").find("'phi' is no name"),
            std::string::npos);
}

}  // namespace
}  // namespace burin::preset
