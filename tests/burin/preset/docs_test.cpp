#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <burin/curves/family.hpp>
#include <burin/preset/load.hpp>

/// docs/presets.md ends with the tables of the format; they are written from the field tables and held to them here.
namespace burin::preset {
namespace {

constexpr const char* marker = "<!-- The rest is written from the code";

std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return text;
}

std::string table(std::string_view title, std::string_view summary, const std::vector<params::FieldInfo>& fields) {
  std::string text = "\n## " + std::string(title) + "\n\n" + std::string(summary) +
                     "\n\n| key | meaning | takes | default |\n|---|---|---|---|\n";
  for (const params::FieldInfo& field : fields) {
    const std::string takes = field.type + (field.range.empty() ? "" : " in " + field.range);
    const std::string unset = field.default_text.empty() ? "" : '`' + cell(field.default_text) + '`';
    text += "| `" + std::string(field.name) + "` | " + cell(std::string(field.doc)) + " | " + cell(takes) + " | " +
            unset + " |\n";
  }
  return text;
}

std::string tables() {
  std::string text;
  for (const FormatTable& format : format_tables()) text += table(format.name, format.summary, format.fields);
  for (const curves::Family& family : curves::catalogue()) {
    text += table("curve: " + std::string(family.name),
                  std::string(family.summary) + ". Source: " + std::string(family.source) + '.', family.fields());
  }
  return text;
}

TEST(Docs, TheFormatsTablesAreTheCodes) {
  const std::string path = std::string(BURIN_SOURCE_DIR) + "/docs/presets.md";
  std::ostringstream read;
  read << std::ifstream(path).rdbuf();
  const std::string page = read.str();
  const std::size_t begin = page.find(marker);
  ASSERT_NE(begin, std::string::npos);
  const std::string prose = page.substr(0, page.find('\n', begin) + 1);
  const std::string expected = prose + tables();
  if (std::getenv("BURIN_BLESS") != nullptr) std::ofstream(path) << expected;
  EXPECT_EQ(page, expected) << "run again with BURIN_BLESS=1 to write docs/presets.md anew";
}

TEST(Docs, TheExamplesLoad) {
  std::ostringstream read;
  read << std::ifstream(std::string(BURIN_SOURCE_DIR) + "/docs/presets.md").rdbuf();
  const std::string page = read.str();
  int examples = 0;
  const std::string fence = "```toml\n";
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at)) {
    at += fence.size();
    const Result<Piece> piece = load({"docs/presets.md", page.substr(at, page.find("```", at) - at)}, {}, {});
    EXPECT_TRUE(piece.ok()) << problems_text(piece.problems());
    ++examples;
  }
  EXPECT_GE(examples, 2);
}

}  // namespace
}  // namespace burin::preset
