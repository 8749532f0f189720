#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <burin/base/random.hpp>
#include <cli/origin.hpp>

namespace burin::cli {
namespace {

std::string read_back(const std::string& toml_value) {
  const toml::table table = toml::parse("text = " + toml_value + '\n');
  return table["text"].value<std::string>().value();
}

TEST(Origin, EveryTextComesBackByteForByte) {
  const std::vector<std::string> texts{"",       "\n",          "\"",    "\"\"\"\"\"\"", "a\"\"\"b\"",
                                       "\\\"\\", "\r\n",        "a\rb",  "\t\x01\x7f",   "\nbegin",
                                       "end\n",  "é ☃ \\u0041", "''' x", "\"\"\"\n\"",   "\\\n  next"};
  for (const std::string& text : texts) {
    EXPECT_EQ(read_back(toml_text(text)), text) << toml_text(text);
    EXPECT_EQ(read_back(toml_string(text)), text) << toml_string(text);
  }
}

TEST(Origin, RandomTextsComeBackToo) {
  const std::string alphabet = "\"\"\"\\\\\n\r\ta'#=[]";
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    std::string text;
    for (std::uint64_t at = 0; at < 12; ++at) text += alphabet[random_bits(seed, at) % alphabet.size()];
    ASSERT_EQ(read_back(toml_text(text)), text) << toml_text(text);
    ASSERT_EQ(read_back(toml_string(text)), text) << toml_string(text);
  }
}

constexpr BackEnd svg_row{"native", "svg", "", Space::page, false, nullptr, nullptr, nullptr, nullptr};
constexpr BackEnd png_row{"cairo", "png", "", Space::page, true, nullptr, nullptr, nullptr, nullptr};

TEST(Origin, HoldsEveryChoiceThatTheOutputDependsOn) {
  DrawRequest request;
  request.overrides.knobs = {{"levels", "5"}, {"motif", "\"x\""}};
  request.overrides.keys = {{"page.paper", "oat"}};
  request.overrides.page_size = "a3";
  request.overrides.landscape = true;
  request.overrides.margin = "1cm 2cm";
  request.overrides.enlarge = "a1";
  request.decimals = 2;
  request.paper = true;
  request.all_points = true;
  request.only = {"one"};
  request.skip = {"two", "three"};
  const PresetText preset{{"folder/of/me/x.toml", "burin = 1\n"}, "x", "x.toml", "folder/of/me"};
  const ReadPiece piece{{}, 0xFFFFFFFFFFFFFFFFU, {{"a.csv", "00ff"}}};

  const std::string record = origin_record(request, svg_row, preset, piece);
  EXPECT_EQ(record, origin_record(request, svg_row, preset, piece));
  EXPECT_EQ(record.find("folder"), std::string::npos);
  const toml::table table = toml::parse(record);
  EXPECT_EQ(table["preset"].value<std::string>(), "x.toml");
  EXPECT_EQ(table["seed"].value<std::string>(), "18446744073709551615");
  EXPECT_EQ(table["knobs"][0].value<std::string>(), "levels=5");
  EXPECT_EQ(table["knobs"][1].value<std::string>(), "motif=\"x\"");
  EXPECT_EQ(table["set"][0].value<std::string>(), "page.paper=oat");
  EXPECT_EQ(table["page"].value<std::string>(), "a3");
  EXPECT_EQ(table["landscape"].value<bool>(), true);
  EXPECT_EQ(table["margin"].value<std::string>(), "1cm 2cm");
  EXPECT_EQ(table["enlarge"].value<std::string>(), "a1");
  EXPECT_EQ(table["format"].value<std::string>(), "svg");
  EXPECT_EQ(table["backend"].value<std::string>(), "native");
  EXPECT_EQ(table["decimals"].value<std::string>(), "2");
  EXPECT_EQ(table["paper"].value<bool>(), true);
  EXPECT_EQ(table["all-points"].value<bool>(), true);
  EXPECT_EQ(table["only"][0].value<std::string>(), "one");
  EXPECT_EQ(table["skip"][1].value<std::string>(), "three");
  EXPECT_EQ(table["text"].value<std::string>(), "burin = 1\n");
  EXPECT_EQ(table["data"][0]["name"].value<std::string>(), "a.csv");
  EXPECT_EQ(table["data"][0]["sha256"].value<std::string>(), "00ff");
  EXPECT_FALSE(table.contains("dpi"));
}

TEST(Origin, AnOutputRecordsNothingOfItsCompanions) {
  DrawRequest request;
  request.dots_per_inch = 72.5;
  const PresetText preset{{"-", ""}, "drawing", "-", ""};
  const toml::table png = toml::parse(origin_record(request, png_row, preset, {}));
  EXPECT_EQ(png["dpi"].value<std::string>(), "72.5");
  EXPECT_FALSE(png.contains("decimals"));
  const std::string svg = origin_record(request, svg_row, preset, {});
  request.longer_side_px = 2000.0;
  EXPECT_EQ(origin_record(request, svg_row, preset, {}), svg);
  const toml::table sized = toml::parse(origin_record(request, png_row, preset, {}));
  EXPECT_EQ(sized["size"].value<std::string>(), "2000px");
}

TEST(Origin, TitleFallsBackToThePresetsName) {
  const PresetText preset{{"a/koch.toml", ""}, "koch", "koch.toml", "a"};
  EXPECT_EQ(make_origin({}, svg_row, preset, {}).title, "koch");
  EXPECT_EQ(make_origin({}, svg_row, preset, {{"T", "A", "S"}, 1, {}}).title, "T");
}

}  // namespace
}  // namespace burin::cli
