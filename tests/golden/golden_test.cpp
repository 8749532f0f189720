#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/curves/two_point/named_motifs.hpp>
#include <burin/preset/symmetry.hpp>

#include "support/run_tool.hpp"

/// The repository's goldens, tests/golden/TOPIC/CASE.toml with .dump and .png, by the command that others use for
/// theirs. `burin golden tests/golden --bless` writes them anew; so does BURIN_BLESS=1 with these tests, which fail
/// then.
namespace burin::test {
namespace {

namespace fs = std::filesystem;

const fs::path tests_folder = fs::path(BURIN_SOURCE_DIR) / "tests";

Finished golden(const fs::path& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{BURIN_TOOL_PATH, "golden", folder.string(), "--threads", "1"};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(words, {});
}

std::vector<std::string> topics() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(tests_folder / "golden")) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<fs::path> presets() {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::recursive_directory_iterator(tests_folder / "golden")) {
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  }
  return paths;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, IsWhatIsDrawn) {
  const fs::path folder = tests_folder / "golden" / GetParam();
  const Finished check = golden(folder);
  if (std::getenv("BURIN_BLESS") != nullptr) golden(folder, {"--bless"});
  EXPECT_EQ(check.code, 0) << check.err;
}

INSTANTIATE_TEST_SUITE_P(Topics, Golden, testing::ValuesIn(topics()), [](const auto& topic) {
  std::string name = topic.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

/// Proves that a wrong drawing is found. Never blessed: it stands in a folder of its own.
TEST(GoldenThatFails, DoesInItsDumpAndInItsPicture) {
  const fs::path folder = tests_folder / "golden_that_fails";
  const Finished check = golden(folder);
  EXPECT_EQ(check.code, 1);
  EXPECT_NE(check.err.find("wrong-on-purpose.dump: line 7 is not the same\n"), std::string::npos) << check.err;
  EXPECT_NE(check.err.find("wrong-on-purpose.png: "), std::string::npos) << check.err;
  EXPECT_NE(check.err.find(" pixels are not the same: max "), std::string::npos) << check.err;
}

// What there must be goldens of.

std::string all_text() {
  std::string all;
  for (const fs::path& path : presets()) {
    std::ifstream in(path, std::ios::binary);
    all.append(std::istreambuf_iterator<char>(in), {});
  }
  return all;
}

TEST(GoldenFolder, HasManySmallCases) {
  EXPECT_GE(presets().size(), 150U);
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(tests_folder / "golden")) {
    if (!entry.is_regular_file()) continue;
    bytes += entry.file_size();
    EXPECT_LT(entry.file_size(), 120'000U) << entry.path();
  }
  EXPECT_LT(bytes, 3'000'000U);
}

TEST(GoldenFolder, HasEveryMotifAndEverySymmetry) {
  const std::string text = all_text();
  for (const auto& motif : curves::two_point::named_motifs()) {
    EXPECT_NE(text.find('"' + std::string(motif.name) + '"'), std::string::npos) << motif.name;
  }
  for (const std::string_view name : preset::tiling_names()) {
    EXPECT_NE(text.find("symmetry = \"" + std::string(name) + '"'), std::string::npos) << name;
  }
}

TEST(GoldenFolder, HasEveryWordOfStrokesFillsSignsAndFonts) {
  const std::string text = all_text();
  for (const char* const word :
       {"caps = \"butt\"",     "caps = \"round\"",       "caps = \"square\"",  "joins = \"miter\"",
        "joins = \"round\"",   "joins = \"bevel\"",      "rule = \"nonzero\"", "rule = \"evenodd\"",
        "sign = \"constant\"", "sign = \"edge\"",        "sign = \"level\"",   "sign = \"level-edge\"",
        "sign = \"random\"",   "mirror = \"x\"",         "mirror = \"y\"",     "mirror = \"xy\"",
        "font = \"sans\"",     "font = \"sans-bold\"",   "font = \"serif\"",   "font = \"serif-bold\"",
        "font = \"italic\"",   "font = \"italic-bold\"", "font = \"script\"",  "font = \"script-bold\"",
        "font = \"gothic\""}) {
    EXPECT_NE(text.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace burin::test
