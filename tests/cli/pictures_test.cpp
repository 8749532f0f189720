#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tool.hpp"

/// The pictures of the README are drawn by the tool, on paper, from the presets they are named after.
namespace burin::test {
namespace {

TEST(Pictures, AreWhatTheToolDraws) {
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(BURIN_SOURCE_DIR) + "/docs/images")) {
    if (!entry.is_regular_file()) continue;
    const std::string preset = entry.path().stem().string();
    const TemporaryFolder folder;
    const Finished drawn = burin_in(folder, {"draw", preset, "--paper", "-o", "-"});
    ASSERT_EQ(drawn.code, 0) << preset << '\n' << drawn.err;
    std::ostringstream kept;
    kept << std::ifstream(entry.path()).rdbuf();
    if (std::getenv("BURIN_BLESS") != nullptr) std::ofstream(entry.path()) << drawn.out;
    EXPECT_TRUE(kept.str() == drawn.out) << preset << ": run again with BURIN_BLESS=1 to draw docs/images anew";
    ++pictures;
  }
  EXPECT_GE(pictures, 3);
}

}  // namespace
}  // namespace burin::test
