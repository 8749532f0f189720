#include <string>

#include <gtest/gtest.h>

#include <burin/data/image.hpp>

#include "cli/tool.hpp"

namespace burin::test {
namespace {

/// Koch curves of two levels and of one again, as PNG.
class Diff : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("koch.toml", koch_text);
    draw("a.png", "3");
    draw("same.png", "3");
    draw("b.png", "2");
  }

  void draw(const std::string& file, const std::string& levels, const std::string& size = "90px") {
    const Finished drawn = burin_in(folder_, {"draw", "koch.toml", "-q", "-o", file, "-D", "levels=" + levels, "--size",
                                              size, "--backend", "native"});
    ASSERT_EQ(drawn.code, 0) << drawn.err;
  }

  Finished diff(std::vector<std::string> words) const {
    words.insert(words.begin(), "diff");
    return burin_in(folder_, std::move(words));
  }

  TemporaryFolder folder_;
};

TEST_F(Diff, EqualPicturesEndWithZero) {
  const Finished equal = diff({"a.png", "same.png"});
  EXPECT_EQ(equal.code, 0);
  EXPECT_EQ(equal.err, "");
  EXPECT_TRUE(contains(equal.out, "a.png and same.png are equal\n")) << equal.out;
  EXPECT_EQ(diff({"a.png", "same.png", "--max", "0", "--mean", "0", "--block", "0"}).code, 0);
}

TEST_F(Diff, DifferentPicturesEndWithOneAndTellHowMuch) {
  const Finished different = diff({"a.png", "b.png"});
  EXPECT_EQ(different.code, 1);
  EXPECT_EQ(different.err, "");
  for (const char* const part :
       {"a.png and b.png differ in ", " pixels\n  max    ", "\n  mean   ", "\n  block  ", "\n  ink    "}) {
    EXPECT_TRUE(contains(different.out, part)) << part << '\n' << different.out;
  }
  const Finished quiet = diff({"a.png", "b.png", "-q"});
  EXPECT_EQ(quiet.code, 1);
  EXPECT_EQ(quiet.out, "");
}

TEST_F(Diff, LimitsThatAreGivenAreAllThatCounts) {
  EXPECT_EQ(diff({"a.png", "b.png", "--max", "255"}).code, 0);
  EXPECT_EQ(diff({"a.png", "b.png", "--mean", "200"}).code, 0);
  EXPECT_EQ(diff({"a.png", "b.png", "--block", "254.5"}).code, 0);
  EXPECT_EQ(diff({"a.png", "b.png", "--max", "255", "--mean", "0"}).code, 1);
  const Finished beyond = diff({"a.png", "b.png", "--max", "1", "--block", "0.5", "--mean", "99"});
  EXPECT_EQ(beyond.code, 1);
  EXPECT_TRUE(contains(beyond.out, ", beyond --max 1 and --block 0.5\n")) << beyond.out;
  EXPECT_TRUE(contains(diff({"a.png", "b.png", "--max", "255"}).out, ", within the limits\n"));
}

TEST_F(Diff, JsonHasTheNumbers) {
  const Finished equal = diff({"a.png", "same.png", "--json"});
  EXPECT_EQ(equal.code, 0);
  EXPECT_TRUE(contains(equal.out,
                       "{\"equal\": true, \"width\": 64, \"height\": 90, \"pixels\": 0, \"max\": 0, \"max_at\": "
                       "[0, 0], \"mean\": 0, \"mean_on_ink\": 0, \"block\": 0, \"block_at\": [0, 0], \"ink\": [0."))
      << equal.out;
  const Finished different = diff({"a.png", "b.png", "--json"});
  EXPECT_EQ(different.code, 1);
  EXPECT_TRUE(contains(different.out, "\"equal\": false"));
}

TEST_F(Diff, ThePictureOfTheDifferenceShowsWhatWasAddedAndWhatIsGone) {
  ASSERT_EQ(diff({"a.png", "b.png", "-o", "d.png"}).code, 1);
  const Result<data::Image> first = data::read_png(folder_.read("a.png"), "a.png");
  const Result<data::Image> second = data::read_png(folder_.read("b.png"), "b.png");
  const Result<data::Image> shown = data::read_png(folder_.read("d.png"), "d.png");
  ASSERT_TRUE(first.ok() && second.ok() && shown.ok());
  ASSERT_EQ(shown->width, first->width);
  ASSERT_EQ(shown->height, first->height);
  int red = 0;
  int blue = 0;
  for (int y = 0; y < shown->height; ++y) {
    for (int x = 0; x < shown->width; ++x) {
      const int before = first->pixel(x, y)[0];
      const int after = second->pixel(x, y)[0];
      const std::uint8_t* const pixel = shown->pixel(x, y);
      const bool is_red = pixel[0] > pixel[2] + 50 && pixel[0] > pixel[1] + 50;
      const bool is_blue = pixel[2] > pixel[0] + 50;
      ASSERT_EQ(is_red, after < before) << x << ',' << y;
      ASSERT_EQ(is_blue, after > before) << x << ',' << y;
      red += is_red ? 1 : 0;
      blue += is_blue ? 1 : 0;
    }
  }
  EXPECT_GT(red, 5);
  EXPECT_GT(blue, 5);
}

TEST_F(Diff, TwoSizesCannotBeCompared) {
  draw("large.png", "3", "91px");
  const Finished sizes = diff({"a.png", "large.png", "-o", "d.png"});
  EXPECT_EQ(sizes.code, 3);
  EXPECT_EQ(sizes.out, "");
  EXPECT_TRUE(
      contains(sizes.err, "large.png: error: has 64 x 91 pixels and a.png has 64 x 90; only pictures of one size"))
      << sizes.err;
  EXPECT_FALSE(folder_.has("d.png"));
}

TEST_F(Diff, WhatCannotBeReadIsToldByName) {
  const std::string whole = folder_.read("a.png");
  folder_.write("cut.png", whole.substr(0, whole.size() / 2));
  std::string damaged = whole;
  damaged[damaged.size() - 30] = static_cast<char>(damaged[damaged.size() - 30] ^ 1);
  folder_.write("damaged.png", damaged);
  const std::pair<std::string, std::string> cases[] = {{"missing.png", "cannot be read"},
                                                       {"koch.toml", "is no PNG"},
                                                       {"cut.png", "is cut short"},
                                                       {"damaged.png", "is a damaged PNG"},
                                                       {".", "is a folder"}};
  for (const auto& [file, words] : cases) {
    const Finished refused = diff({"a.png", file});
    EXPECT_EQ(refused.code, 3) << file;
    EXPECT_TRUE(contains(refused.err, file + ": error: " + words)) << refused.err;
  }
}

TEST_F(Diff, WrongCommandLinesAreUsage) {
  EXPECT_EQ(diff({"a.png"}).code, 2);
  EXPECT_EQ(diff({"a.png", "b.png", "same.png"}).code, 2);
  const Finished limits = diff({"a.png", "b.png", "--max", "256", "--mean", "little"});
  EXPECT_EQ(limits.code, 2);
  EXPECT_TRUE(contains(limits.err, "--max must be a number from 0 to 255, not '256'")) << limits.err;
  EXPECT_TRUE(contains(limits.err, "--mean must be a number from 0 to 255, not 'little'")) << limits.err;
}

TEST_F(Diff, APictureThatCannotBeWrittenIsAnError) {
  const Finished refused = diff({"a.png", "b.png", "-o", "no/where.png"});
  EXPECT_EQ(refused.code, 5);
  EXPECT_TRUE(contains(refused.err, "no/where.png")) << refused.err;
}

}  // namespace
}  // namespace burin::test
