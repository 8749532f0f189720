#include "renderers/programs.hpp"

/// Curves with every one of their millions of points, in programs as they come: no option that lifts a limit.
namespace burin::test {
namespace {

/// Reads a Koch curve with all its points as SVG; our PNG, drawn with the points that can show, looks the same.
void expect_to_open(const std::string& levels) {
  const TemporaryFolder folder;
  draw(folder, "koch", "all.svg", {"--paper", "--all-points", "-D", "levels=" + levels});
  draw(folder, "koch", "ours.png", {"--size", "1000px", "-D", "levels=" + levels});
  run_silently_in(folder, {"xmllint", "--huge", "--noout", "all.svg"});
  const GreyPicture ours = read_png(folder.file("ours.png"));
  expect_alike(ours, seen_by_rsvg(folder, "all", in_pixels(ours)));
}

TEST(LargeFiles, AMillionSegmentsOpen) {
  expect_to_open("10");
}

TEST(LargeFiles, SixteenMillionSegmentsOpen) {
  expect_to_open("12");
}

TEST(LargeFiles, APngOfAllPointsIsNoDarker) {
  const TemporaryFolder folder;
  draw(folder, "koch", "ours.png", {"--size", "1000px", "-D", "levels=12"});
  draw(folder, "koch", "all.png", {"--size", "1000px", "-D", "levels=12", "--all-points"});
  expect_alike(read_png(folder.file("ours.png")), read_png(folder.file("all.png")));
}

}  // namespace
}  // namespace burin::test
