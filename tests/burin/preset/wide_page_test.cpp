#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <burin/burin.hpp>
#include <burin/output/back_ends.hpp>

/// A page whose rows are long is packed a few rows at a time.
namespace burin {
namespace {

std::size_t png_bytes(double dots_per_mm) {
  const Result<preset::Plan> plan = load({"test.toml", R"(
burin = 1
page = { size = "300x200mm", margin = "20mm" }
pens = { ink = { color = "#8c2f1b", width = "0.5mm" } }
layer = [{ curve = { family = "two-point", motif = "dragon", levels = 12 } }]
)"});
  StringSink bytes;
  for (const BackEnd& back_end : output::back_ends()) {
    if (back_end.format == "png") EXPECT_TRUE(write(*plan, back_end, bytes, {.dots_per_mm = dots_per_mm}));
  }
  return bytes.take().size();
}

TEST(WidePage, GrowsByWhatItShowsNotByItsRows) {
  // Five times the width has edges five times as long, of few shapes, many to a row. What is added is for stripes that
  // begin anew.
  const std::size_t narrow = png_bytes(2000.0 / 300.0);
  const std::size_t wide = png_bytes(10'000.0 / 300.0);
  EXPECT_LE(wide, narrow * 8);
}

}  // namespace
}  // namespace burin
