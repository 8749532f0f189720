#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/burin.hpp>

/// Golden drawings: tests/golden/TOPIC/CASE.toml and beside it the canonical dump it must give, byte for byte.
namespace burin {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

fs::path folder() {
  return fs::path(BURIN_SOURCE_DIR) / "tests" / "golden";
}

std::string dump_of(const fs::path& preset) {
  const Result<preset::Plan> plan = load({preset.filename().string(), read_file(preset)});
  if (!plan) return problems_text(plan.problems());
  StringSink bytes;
  const Result<Done> written = write(*plan, "dump", bytes);
  return written ? bytes.text() : problems_text(written.problems());
}

/// Where two texts part: the first line that differs, of both; empty when they are the same.
std::string difference(const std::string& golden, const std::string& drawn) {
  if (golden == drawn) return {};
  std::istringstream a(golden);
  std::istringstream b(drawn);
  std::string golden_line;
  std::string drawn_line;
  for (int line = 1;; ++line) {
    const bool more_golden = static_cast<bool>(std::getline(a, golden_line));
    const bool more_drawn = static_cast<bool>(std::getline(b, drawn_line));
    if (golden_line != drawn_line || more_golden != more_drawn) {
      return "line " + std::to_string(line) + "\n  golden: " + (more_golden ? golden_line.substr(0, 200) : "(ends)") +
             "\n  drawn:  " + (more_drawn ? drawn_line.substr(0, 200) : "(ends)");
    }
    if (!more_golden) return "only the ends of their last lines";
  }
}

std::vector<std::string> cases() {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder())) {
    if (entry.path().extension() == ".toml")
      found.push_back(fs::relative(entry.path(), folder()).replace_extension().string());
  }
  std::sort(found.begin(), found.end());
  return found;
}

class Golden : public ::testing::TestWithParam<std::string> {};

TEST_P(Golden, DrawsItsDump) {
  const fs::path preset = folder() / (GetParam() + ".toml");
  const fs::path dump = folder() / (GetParam() + ".dump");
  const std::string drawn = dump_of(preset);
  const std::string golden = read_file(dump);
  // Proves that a wrong drawing is found; never blessed.
  const bool wrong_on_purpose = GetParam() == "wrong-on-purpose";
  if (std::getenv("BURIN_BLESS") != nullptr && !wrong_on_purpose) std::ofstream(dump) << drawn;
  const std::string parted = difference(golden, drawn);
  EXPECT_EQ(parted.empty(), !wrong_on_purpose) << parted << "\n(BURIN_BLESS=1 writes it anew)";
}

INSTANTIATE_TEST_SUITE_P(All, Golden, ::testing::ValuesIn(cases()), [](const auto& golden) {
  std::string name = golden.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

TEST(GoldenFolder, HasADumpForEveryCaseAndACaseForEveryDump) {
  const std::vector<std::string> presets = cases();
  EXPECT_GE(presets.size(), 40U);
  for (const auto& entry : fs::recursive_directory_iterator(folder())) {
    if (entry.path().extension() != ".dump") continue;
    const std::string name = fs::relative(entry.path(), folder()).replace_extension().string();
    EXPECT_TRUE(std::binary_search(presets.begin(), presets.end(), name)) << name << ".dump has no preset";
  }
}

}  // namespace
}  // namespace burin
