#include <gtest/gtest.h>

#include <burin/base/units.hpp>

namespace burin {
namespace {

TEST(Units, MillimetresInOneOfEach) {
  EXPECT_EQ(mm_per_unit(""), 1.0);
  EXPECT_EQ(mm_per_unit("mm"), 1.0);
  EXPECT_EQ(mm_per_unit("cm"), 10.0);
  EXPECT_EQ(mm_per_unit("m"), 1000.0);
  EXPECT_EQ(mm_per_unit("in"), 25.4);
  EXPECT_DOUBLE_EQ(72.0 * mm_per_unit("pt").value(), 25.4);
  EXPECT_DOUBLE_EQ(6.0 * mm_per_unit("pc").value(), 25.4);
  EXPECT_DOUBLE_EQ(96.0 * mm_per_unit("px").value(), 25.4);
  for (const char* unknown : {"MM", "km", "m m", "em", "%"}) EXPECT_FALSE(mm_per_unit(unknown)) << unknown;
}

TEST(Units, SuffixIsTheTrailingLetters) {
  EXPECT_EQ(unit_suffix_begin("15mm"), 2U);
  EXPECT_EQ(unit_suffix_begin("($w*2)mm"), 6U);
  EXPECT_EQ(unit_suffix_begin("15"), 2U);
  EXPECT_EQ(unit_suffix_begin("15 pt"), 3U);
  EXPECT_EQ(unit_suffix_begin(""), 0U);
  EXPECT_EQ(unit_suffix_begin("mm"), 0U);
}

}  // namespace
}  // namespace burin
