#include <gtest/gtest.h>

#include <burin/preset/plan.hpp>

#include "preset_text.hpp"

namespace burin::preset {
namespace {

TEST(Pens, InksReachTheSheet) {
  const Result<Plan> plan = Plan::make(
      piece_of("[knobs]\nred = { default = 90, min = 0, max = 100, doc = \"magenta\" }\n[pens]\n"
               "plain = {}\nwarm = { color = \"tomato\", cmyk = [0, \"$red\", 100, 12.5], spot = \"Pantone 485 C\" }"));
  ASSERT_TRUE(plan);
  const std::vector<Pen>& pens = plan->sheet().pens;
  ASSERT_EQ(pens.size(), 2U);
  EXPECT_FALSE(pens[0].cmyk);
  EXPECT_EQ(pens[0].spot, "");
  EXPECT_EQ(pens[1].cmyk, (Cmyk{0.0, 0.9, 1.0, 0.125}));
  EXPECT_EQ(pens[1].spot, "Pantone 485 C");
}

TEST(Pens, InksArePercents) {
  EXPECT_EQ(complaints_in("[pens]\nink = { cmyk = [0, 101, 0, -1] }"),
            "p.toml:3:16: error: 'cmyk': an ink of 101 percent is outside [0, 100]\n"
            "p.toml:3:16: error: 'cmyk': an ink of -1 percent is outside [0, 100]\n");
  EXPECT_NE(complaints_in("[pens]\nink = { cmyk = [0, 1, 0] }"), "");
}

}  // namespace
}  // namespace burin::preset
