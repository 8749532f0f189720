#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/tool.hpp"
#include "support/temporary_folder.hpp"

namespace burin::test {
namespace {

nlohmann::json measured(const TemporaryFolder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), "measure");
  words.emplace_back("--json");
  const Finished run = burin_in(folder, words);
  EXPECT_EQ(run.code, 0) << run.err;
  return run.code == 0 ? nlohmann::json::parse(run.out) : nlohmann::json::object();
}

constexpr const char* square = R"(burin = 1
page = { size = "100x100mm", margin = "10mm" }
[slots]
all = { at = "0 0 100% 100%", scale = "10mm" }
[[layer]]
slot = "all"
curve = { family = "two-point", base = "square", levels = 0 }
)";

TEST(Measure, KochHasItsLengthAndDimension) {
  const TemporaryFolder folder;
  const nlohmann::json koch = measured(folder, {"koch", "-D", "levels=6"});
  EXPECT_EQ(koch["points"], 4097);
  EXPECT_NEAR(koch["length"].get<double>(), std::pow(4.0 / 3.0, 6), 1e-12);
  EXPECT_NEAR(koch["box_dimension"].get<double>(), std::log(4.0) / std::log(3.0), 0.02);
  EXPECT_NEAR(koch["similarity_dimension"]["koch"].get<double>(), std::log(4.0) / std::log(3.0), 1e-12);
  EXPECT_NEAR(koch["bounds"][3].get<double>(), std::sqrt(3.0) / 6.0, 1e-12);
}

TEST(Measure, APresetAndItsCsvAgree) {
  const TemporaryFolder folder;
  for (const std::string name : {"koch", "sierpinski-star", "friezes"}) {
    ASSERT_EQ(burin_in(folder, {"draw", name, "-q", "-o", "a.csv"}).code, 0);
    const nlohmann::json preset = measured(folder, {name});
    const nlohmann::json file = measured(folder, {"a.csv"});
    for (const char* key : {"paths", "points", "length", "box_dimension", "turn_degrees", "bounds", "area"}) {
      EXPECT_EQ(preset[key], file[key]) << name << ' ' << key;
    }
  }
}

TEST(Measure, ThePageIsInMillimetres) {
  const TemporaryFolder folder;
  folder.write("square.toml", square);
  const nlohmann::json page = measured(folder, {"square.toml"})["page"];
  EXPECT_NEAR(page["length_mm"].get<double>(), 40.0, 1e-9);
  EXPECT_EQ(page["strokes"], 1);
  EXPECT_NEAR(page["ink"].get<double>(), 40.0 * 0.3 / (80.0 * 80.0), 1e-4);
  EXPECT_EQ(page["dense_windows"], 0);
  for (const auto& margin : page["margins_mm"]) EXPECT_NEAR(margin.get<double>(), 50.0 - 5.0 - 0.15, 0.2);
}

TEST(Measure, ALayerByItselfAndColoursDoNotMatter) {
  const TemporaryFolder folder;
  const nlohmann::json all = measured(folder, {"four-classics"});
  const nlohmann::json one = measured(folder, {"four-classics", "--only", "koch"});
  EXPECT_LT(one["points"], all["points"]);
  EXPECT_LT(one["page"]["ink"], all["page"]["ink"]);
  const nlohmann::json pale = measured(folder, {"koch", "--set", "pens.ink.color=#eeeeee"});
  EXPECT_EQ(pale["page"]["ink"], measured(folder, {"koch"})["page"]["ink"]);
}

TEST(Measure, FilesOfPointsMayGoAround) {
  const TemporaryFolder folder;
  folder.write("square.csv", "x,y\n0,0\n4,0\n4,4\n0,4\n");
  EXPECT_EQ(measured(folder, {"square.csv"})["length"], 12);
  const nlohmann::json closed = measured(folder, {"square.csv", "--closed"});
  EXPECT_EQ(closed["length"], 16);
  EXPECT_EQ(closed["area"], 16);
  EXPECT_EQ(closed["turn_degrees"], 360);
}

TEST(Measure, SvgIsReadWithItsTransforms) {
  const TemporaryFolder folder;
  folder.write("a.svg",
               "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><g transform='scale(2)' fill='none' "
               "stroke='black'><path d='M0 0 H10 V10 H0 Z'/></g></svg>");
  const nlohmann::json file = measured(folder, {"a.svg"});
  EXPECT_EQ(file["length"], 80);
  EXPECT_EQ(file["units"], "px");
}

TEST(Measure, HowFarACurveIsFromAnother) {
  const TemporaryFolder folder;
  folder.write("a.csv", "0,0\n5,0\n10,0\n");
  folder.write("b.csv", "0,3\n10,3\n");
  const nlohmann::json file = measured(folder, {"a.csv", "--against", "b.csv"});
  EXPECT_DOUBLE_EQ(file["rmse"].get<double>(), 3.0);
  EXPECT_DOUBLE_EQ(file["rmse_of_longer_side"].get<double>(), 0.3);
}

/// A preset of one curve with this text of its own, called "it".
std::string preset_of(const std::string& curve) {
  return "burin = 1\n[[layer]]\nname = \"it\"\n[layer.curve]\n" + curve;
}

const std::string rough_graph = R"(family = "fractal-interpolation"
points = [[0, 0], [0.25, 0.8], [0.5, 0.2], [0.75, 1], [1, 0.3]]
alpha = 1.5
beta = 0.7
)";

TEST(Measure, TellsHowSmoothTheLimitIs) {
  const TemporaryFolder folder;
  const auto smoothness = [&](const std::string& curve) {
    folder.write("it.toml", preset_of(curve));
    return measured(folder, {"it.toml"})["smoothness"]["it"];
  };
  const nlohmann::json classical = smoothness("family = \"four-point\"\nw = 0.0625\nbase = \"square\"\n");
  EXPECT_EQ(classical["proven"], 1);
  EXPECT_EQ(classical["excluded"], 2);
  EXPECT_NEAR(classical["exponent_high"].get<double>(), 2.0, 1e-6);
  EXPECT_EQ(smoothness("family = \"de-rham\"\nt = 1.2\n")["excluded"], 0);
  EXPECT_EQ(smoothness("family = \"four-parameter\"\nlambda = 0.125\nmu = 0.125\nomega = 0\n")["proven"], 2);
  EXPECT_EQ(smoothness(rough_graph + "scaling = 0.2\n")["proven"], 1);
  EXPECT_TRUE(smoothness(rough_graph + "scaling = 0.2\n")["excluded"].is_null());
  EXPECT_EQ(smoothness(rough_graph + "scaling = 0.5\n")["excluded"], 1);
  const Finished text = burin_in(folder, {"measure", "it.toml"});
  EXPECT_NE(text.out.find("C0 proven, C1 excluded, H\u00f6lder exponent from 0.5000 to 0.5000 (it)"), std::string::npos)
      << text.out;
}

TEST(Measure, TellsBoundsOfAFractalInterpolationsDimension) {
  const TemporaryFolder folder;
  const auto dimension = [&](const std::string& curve) {
    folder.write("it.toml", preset_of(curve));
    return measured(folder, {"it.toml"})["fractal_dimension"]["it"];
  };
  const nlohmann::json constant = dimension(rough_graph + "scaling = 0.5\n");
  for (const char* key : {"lower", "upper", "spectral"}) EXPECT_NEAR(constant[key].get<double>(), 1.5, 1e-9) << key;
  EXPECT_EQ(constant["certificate"], 3);
  const nlohmann::json linear = dimension(rough_graph + "scaling = [[0.5, 0.4]]\n");
  EXPECT_NEAR(linear["upper"].get<double>(), 1.924, 5e-4);
  EXPECT_NEAR(linear["spectral"].get<double>(), 1.5460, 1e-4);
  EXPECT_EQ(linear["lower"], 1);
  const nlohmann::json contour = dimension(rough_graph + "scaling = 0.4\nover = \"chords\"\nlevels = 1\n");
  EXPECT_TRUE(contour["spectral"].is_null());
  EXPECT_GT(contour["upper"].get<double>(), 1.5);
  // A part of a curve and what is no curve have none.
  EXPECT_TRUE(dimension(rough_graph + "part = [0.2, 0.3]\n").is_null());
  EXPECT_TRUE(dimension(rough_graph + "plot = \"nodes\"\n").is_null());
  EXPECT_TRUE(measured(folder, {"koch"})["fractal_dimension"].empty());
}

TEST(Measure, ThePlotIsAPictureOfTheCounts) {
  const TemporaryFolder folder;
  ASSERT_EQ(burin_in(folder, {"measure", "koch", "--plot", "plot.svg"}).code, 0);
  const std::string svg = folder.read("plot.svg");
  EXPECT_NE(svg.find("inkscape:label=\"3 fit 0.5\""), std::string::npos);
  EXPECT_NE(svg.find("Boxes met by koch"), std::string::npos);
}

TEST(Measure, MistakesTeach) {
  const TemporaryFolder folder;
  folder.write("dot.csv", "1,1\n");
  const auto complaint = [&](std::vector<std::string> words, int code) {
    words.insert(words.begin(), "measure");
    const Finished run = burin_in(folder, words);
    EXPECT_EQ(run.code, code) << run.err;
    return run.err;
  };
  EXPECT_NE(complaint({"koch", "--closed"}, 2).find("files of points"), std::string::npos);
  EXPECT_NE(complaint({"koch", "--seed", "0..3"}, 2).find("one seed"), std::string::npos);
  EXPECT_NE(complaint({"koch", "--plot", "a.csv"}, 2).find("svg, pdf or png"), std::string::npos);
  EXPECT_NE(complaint({"dot.csv", "--against", "dot.csv"}, 3).find("has no length"), std::string::npos);
  EXPECT_NE(complaint({"no.csv"}, 3).find("no.csv"), std::string::npos);
  EXPECT_NE(complaint({}, 2).find("burin measure"), std::string::npos);
  EXPECT_TRUE(folder.names() == std::vector<std::string>{"dot.csv"});
}

}  // namespace
}  // namespace burin::test
