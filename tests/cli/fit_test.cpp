#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <burin/base/number_text.hpp>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

using nlohmann::json;

/// A noisy arch of `count` points.
std::string arch(int count, const std::string& separator = ",", const std::string& line_end = "\n") {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) / (count - 1);
    text += shortest_text(x) + separator + shortest_text(x * (1.0 - x) + (i * 7 % 5) * 0.001) + line_end;
  }
  return text;
}

json fit_json(const TemporaryFolder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), "fit");
  words.emplace_back("--json");
  const Finished run = burin_in(folder, words);
  EXPECT_EQ(run.code, 0) << run.err;
  return json::parse(run.out);
}

TEST(Fit, ComparesFourMethods) {
  const TemporaryFolder folder;
  const json fit = fit_json(folder, {"fibonacci_spiral", "--intervals", "12"});
  EXPECT_EQ(fit["points"], 2101);
  EXPECT_EQ(fit["intervals"], 12);
  EXPECT_EQ(
      fit["parameters"],
      (json{
          {"cubic_spline", 39}, {"polynomial_function", 87}, {"rational_constant", 111}, {"rational_function", 135}}));
  const json& rmse = fit["rmse"];
  EXPECT_NEAR(rmse["cubic_spline"], 0.03094, 1e-5);
  EXPECT_GT(rmse["cubic_spline"], rmse["polynomial_function"]);
  EXPECT_GT(rmse["polynomial_function"], rmse["rational_constant"]);
  EXPECT_GT(rmse["rational_constant"], rmse["rational_function"]);
  const Finished text = burin_in(folder, {"fit", "fibonacci_spiral", "--intervals", "12"});
  EXPECT_TRUE(contains(text.out, "2101 points, 12 intervals")) << text.out;
  EXPECT_TRUE(contains(text.out, "cubic-spline           0.030940")) << text.out;
}

TEST(Fit, IsThePlaneCurveWhateverItsScaleAndFormat) {
  const TemporaryFolder folder;
  folder.write("plain.csv", arch(101));
  folder.write("windows.csv", "sep;y\r\n" + arch(101, ";", "\r\n"));
  folder.write("blanks.csv", "\xEF\xBB\xBF# an arch\n\n" + arch(101, "  "));
  const json plain = fit_json(folder, {"plain.csv", "--intervals", "5"});
  EXPECT_EQ(fit_json(folder, {"windows.csv", "--intervals", "5"}), plain);
  EXPECT_EQ(fit_json(folder, {"blanks.csv", "--intervals", "5"}), plain);
}

TEST(Fit, WritesAPresetThatDrawsTheFitOverTheData) {
  const TemporaryFolder folder;
  folder.write("arch.csv", arch(101));
  for (const char* scaling : {"constant", "function"}) {
    const Finished fit =
        burin_in(folder, {"fit", "arch.csv", "--intervals", "5", "--scaling", scaling, "-o", "fitted.toml"});
    EXPECT_EQ(fit.code, 0) << fit.err;
    const Finished draw = burin_in(folder, {"draw", "fitted.toml", "-o", "fitted.csv"});
    EXPECT_EQ(draw.code, 0) << draw.err;
    const std::string points = folder.read("fitted.csv");
    EXPECT_TRUE(contains(points, "\nfit,0,0,0\n")) << points.substr(0, 500);
    EXPECT_TRUE(contains(points, "\nknots,5,1,0\n")) << points.substr(0, 500);
  }
  // Whatever folder it is written to, and closed.
  EXPECT_EQ(shell_in(folder,
                     "mkdir sub && burin fit arch.csv --intervals 9 --closed -o sub/fitted.toml && burin draw "
                     "sub/fitted.toml -o a.svg && burin fit arch.csv --intervals 5 -o - > c.toml && burin "
                     "check c.toml")
                .code,
            0);
}

TEST(Fit, DropsRepeatedPointsWithACountedWarning) {
  const TemporaryFolder folder;
  folder.write("twice.csv", "0,0\n" + arch(30) + "1,0.003\n1,0.003\n");
  const Finished run = burin_in(folder, {"fit", "twice.csv", "--intervals", "3"});
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(contains(run.err, "twice.csv:2: warning: 3 points are dropped that repeat the point before")) << run.err;
}

TEST(Fit, PresetsWarnOfRepeatedPointsToo) {
  const TemporaryFolder folder;
  folder.write("twice.csv", "0,0\n" + arch(30));
  folder.write("it.toml",
               "burin = 1\n[[layer]]\ncurve = { family = \"fractal-interpolation\", data = \"twice.csv\" }\n"
               "[[layer]]\nname = \"again\"\ncurve = { family = \"fractal-interpolation\", data = \"twice.csv\", "
               "levels = 0 }\n");
  const std::string warning = "twice.csv:2: warning: 1 point is dropped that repeats the point before\n";
  EXPECT_EQ(burin_in(folder, {"check", "it.toml"}).err, warning);
  const Finished draw = burin_in(folder, {"draw", "it.toml", "-o", "it.svg"});
  EXPECT_EQ(draw.code, 0);
  EXPECT_TRUE(contains(draw.err, warning)) << draw.err;
  EXPECT_EQ(burin_in(folder, {"draw", "it.toml", "-q", "-o", "it.svg"}).err, "");
}

TEST(Fit, BadDataIsToldWithItsLine) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& text) {
    folder.write("bad.csv", text);
    const Finished run = burin_in(folder, {"fit", "bad.csv", "--intervals", "3"});
    EXPECT_EQ(run.code, 3) << text;
    EXPECT_EQ(run.out, "");
    return run.err;
  };
  EXPECT_TRUE(contains(error("0,0\n1,nan\n2,0\n3,1\n4,0\n"), "bad.csv:2:3: error: expected a number, not 'nan'"));
  EXPECT_TRUE(contains(error("0,0\n1,1e999\n2,0\n3,1\n4,0\n"), "bad.csv:2:3: error:"));
  EXPECT_TRUE(contains(error("0,0\n1\n"), "bad.csv:2:1: error: expected at least 2 columns"));
  EXPECT_TRUE(contains(error("0,0\n"), "bad.csv: error: has 1 point; 3 intervals need at least 4"));
  EXPECT_TRUE(contains(error("0,0\n0,0\n0,0\n0,0\n"), "has 1 point"));
  EXPECT_TRUE(contains(error(""), "has no points"));
  EXPECT_EQ(burin_in(folder, {"fit", "none.csv", "--intervals", "3"}).code, 3);
}

TEST(Fit, TheCommandLineIsChecked) {
  const TemporaryFolder folder;
  const auto error = [&](const std::vector<std::string>& words) {
    const Finished run = burin_in(folder, words);
    EXPECT_EQ(run.code, 2);
    return run.err;
  };
  EXPECT_TRUE(contains(error({"fit"}), "name one CSV file"));
  EXPECT_TRUE(contains(error({"fit", "fibonacci_spiral"}), "--intervals N"));
  EXPECT_TRUE(contains(error({"fit", "fibonacci_spiral", "--intervals", "1"}), "from 2 to 100000, not '1'"));
  EXPECT_TRUE(contains(error({"fit", "fibonacci_spiral", "--intervals", "2.5"}), "'2.5'"));
  EXPECT_TRUE(contains(error({"fit", "a", "--intervals", "9", "--scaling", "linear"}), "constant or function"));
}

}  // namespace
}  // namespace burin::test
