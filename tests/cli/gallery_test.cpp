#ifdef BURIN_HAS_CAIRO  // thumbnails are drawn by Cairo

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/sha256.hpp>
#include <cli/gallery_page.hpp>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

namespace fs = std::filesystem;

TEST(Gallery, OfTheRepositoryIsWhatItsPresetsDraw) {
  ToolSetup setup;
  setup.folder = BURIN_SOURCE_DIR;
  const Finished check = run_program(tool_words({"gallery", "--check"}), setup);
  if (std::getenv("BURIN_BLESS") != nullptr) run_program(tool_words({"gallery"}), setup);
  EXPECT_EQ(check.code, 0) << check.err << "(BURIN_BLESS=1 ctest -R Gallery, or burin gallery, draws it anew)";
}

/// A folder with two presets and their gallery.
class SmallGallery : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directory(folder_.path() / "presets");
    folder_.write("presets/b.toml", koch_text);
    folder_.write("presets/a-1.toml",
                  "burin = 1\nseed = 7\nabout = { title = \"A|<1>\", summary = \"*Stars* & `code`\" }\n"
                  "page = { size = \"60x90mm\", margin = \"5mm\", paper = \"oat\" }\n"
                  "[[layer]]\ncurve = { family = \"two-point\", sign = \"random\", levels = 3 }\n");
    const Finished drawn = burin_in(folder_, {"gallery"});
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_EQ(drawn.out, "gallery: 2 pieces; 6 files written\n");
  }

  Finished check() const { return burin_in(folder_, {"gallery", "--check"}); }

  TemporaryFolder folder_;
};

TEST_F(SmallGallery, HoldsWhatItsCommandsDraw) {
  for (const std::string name : {"a-1", "b"}) {
    const std::string preset = "presets/" + name + ".toml";
    ASSERT_EQ(burin_in(folder_, {"draw", preset, "-q", "--paper", "--defs", "-o", "c.svg"}).code, 0);
    EXPECT_TRUE(folder_.read("gallery/" + name + ".svg") == folder_.read("c.svg"));
    ASSERT_EQ(burin_in(folder_, {"draw", preset, "-q", "--size", "480px", "-o", "c.png"}).code, 0);
    EXPECT_TRUE(folder_.read("gallery/" + name + ".png") == folder_.read("c.png"));
    const Finished dump = burin_in(folder_, {"draw", preset, "-q", "--format", "dump", "-o", "-"});
    EXPECT_TRUE(contains(folder_.read("gallery/digests.txt"), sha256_hex(dump.out) + "  " + name + '\n'));
  }
}

TEST_F(SmallGallery, PageTellsOfEveryPieceInOrder) {
  const std::string page = folder_.read("gallery/README.md");
  const std::string first =
      "<a id=\"a-1\"></a>\n\n## A\\|\\<1\\>\n\n\\*Stars\\* \\& \\`code\\`\n\n[![A\\|\\<1\\>](a-1.png)](a-1.svg)\n\n"
      "    burin draw a-1 --paper --defs -o a-1.svg\n\n"
      "60 × 90 mm, seed 7, preset [a-1.toml](../presets/a-1.toml).\n\nIt has no knobs.\n";
  const std::string second =
      "<a id=\"b\"></a>\n\n## Test curve\n\n[![Test curve](b.png)](b.svg)\n\n    burin draw b --paper --defs -o "
      "b.svg\n\n"
      "210 × 297 mm, seed 1 (nothing in it is random), preset [b.toml](../presets/b.toml).\n\n"
      "| knob | what it does | takes | default |\n|---|---|---|---|\n"
      "| `levels` | refinement levels | whole number in \\[0, 1000\\] | `3` |\n";
  EXPECT_TRUE(contains(page, first)) << page;
  EXPECT_TRUE(contains(page, second)) << page;
  EXPECT_LT(page.find(first), page.find(second));
  EXPECT_TRUE(contains(page, "<img src=\"a-1.png\" height=\"180\" alt=\"A|&lt;1&gt;\">")) << page;
}

TEST_F(SmallGallery, IsTheSameEachTimeAndFilesKeepTheirDates) {
  const auto date = fs::last_write_time(folder_.file("gallery/a-1.png"));
  EXPECT_EQ(burin_in(folder_, {"gallery"}).out, "gallery: 2 pieces; 0 files written\n");
  EXPECT_EQ(fs::last_write_time(folder_.file("gallery/a-1.png")), date);
  ASSERT_EQ(burin_in(folder_, {"gallery", "-o", "again", "--presets", "presets", "-q"}).code, 0);
  for (const auto& file : fs::directory_iterator(folder_.path() / "gallery")) {
    const std::string name = file.path().filename().string();
    EXPECT_TRUE(folder_.read("gallery/" + name) == folder_.read("again/" + name)) << name;
  }
}

TEST_F(SmallGallery, CheckNamesEveryDifferenceAndChangesNothing) {
  EXPECT_EQ(check().code, 0);
  const auto expect_difference = [&](const std::string& message) {
    const std::vector<std::string> before = folder_.names();
    const Finished differs = check();
    EXPECT_EQ(differs.code, 3);
    EXPECT_TRUE(contains(differs.err, message)) << differs.err;
    EXPECT_EQ(check().err, differs.err);
    ASSERT_EQ(burin_in(folder_, {"gallery", "-q"}).code, 0);
    const Finished again = check();
    EXPECT_EQ(again.code, 0) << again.err;
  };
  folder_.write("gallery/b.svg", folder_.read("gallery/b.svg") + ' ');
  expect_difference("gallery/b.svg: is not what would be drawn");
  folder_.write("gallery/README.md", "by hand");
  expect_difference("gallery/README.md: is not what would be drawn");
  folder_.write("gallery/digests.txt", "");
  expect_difference("gallery/digests.txt: is not what would be drawn");
  fs::remove(folder_.file("gallery/a-1.png"));
  expect_difference("gallery/a-1.png: is missing");
  folder_.write("gallery/b.png", folder_.read("gallery/a-1.png"));
  expect_difference("gallery/b.png: is not what would be drawn");
  folder_.write("presets/b.toml", std::string(koch_text) + "caps = \"butt\"\n");
  expect_difference("gallery/b.png: is not what would be drawn");
}

TEST_F(SmallGallery, PicturesOfPiecesThatAreNoMoreGoAndOthersStay) {
  folder_.write("gallery/notes.txt", "mine");
  folder_.write("gallery/mine.svg", "mine");
  fs::remove(folder_.file("presets/b.toml"));
  EXPECT_TRUE(contains(check().err, "gallery/b.svg: no preset is called so any more"));
  ASSERT_EQ(burin_in(folder_, {"gallery", "-q"}).code, 0);
  EXPECT_FALSE(folder_.has("gallery/b.svg") || folder_.has("gallery/b.png"));
  EXPECT_TRUE(folder_.has("gallery/notes.txt") && folder_.has("gallery/mine.svg"));
}

TEST_F(SmallGallery, AWrongPresetIsToldAndNothingIsWritten) {
  folder_.write("presets/c.toml", "burin = 1\n[[layer]]\ncurve = \"nothing\"\n");
  folder_.write("presets/d.toml", "burin = 2\n");
  const std::string before = folder_.read("gallery/README.md");
  const Finished wrong = burin_in(folder_, {"gallery"});
  EXPECT_EQ(wrong.code, 3);
  EXPECT_TRUE(contains(wrong.err, "presets/c.toml:3:")) << wrong.err;
  EXPECT_TRUE(contains(wrong.err, "presets/d.toml:1:")) << wrong.err;
  EXPECT_EQ(folder_.read("gallery/README.md"), before);
  EXPECT_FALSE(folder_.has("gallery/c.svg"));
}

TEST(GalleryCommand, RefusesWhatItDoesNotTake) {
  const TemporaryFolder folder;
  EXPECT_EQ(burin_in(folder, {"gallery", "koch"}).code, 2);
  EXPECT_EQ(burin_in(folder, {"gallery", "--presets", "nowhere"}).code, 2);
  folder.write("file", "");
  EXPECT_EQ(burin_in(folder, {"gallery", "-o", "file"}).code, 5);
}

}  // namespace
}  // namespace burin::test

#endif
