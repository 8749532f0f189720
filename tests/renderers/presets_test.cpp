#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numeric>

#include "renderers/programs.hpp"

/// Every shipped preset, at its defaults, read by librsvg, MuPDF, libxml2, qpdf and pngcheck.
namespace burin::test {
namespace {

constexpr double mm_per_inch = 25.4;

std::vector<std::string> shipped_presets() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(BURIN_SOURCE_DIR "/presets")) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

struct PageSize {
  double width_mm = 0.0;
  double height_mm = 0.0;
};

/// The longer side in dots, near 1000, at which a page ends with a dot on both sides: one that ends within a dot, the
/// programs of others stretch.
int whole_dots(const PageSize& page) {
  const long width = std::lround(page.width_mm * 10.0);
  const long height = std::lround(page.height_mm * 10.0);
  const int step = static_cast<int>(std::max(width, height) / std::gcd(width, height));
  return 1000 / step * step;
}

class Shipped : public testing::TestWithParam<std::string> {
 protected:
  /// The preset on its paper in every format: ours.png, native.svg, cairo.svg, page.pdf, native.pdf, the last as if it
  /// had no bleed, which would need a larger sheet.
  void draw_all(const std::vector<std::string>& png_options) const {
    draw(folder, GetParam(), "ours.png", png_options);
    draw(folder, GetParam(), "native.svg", {"--paper"});
    draw(folder, GetParam(), "cairo.svg", {"--paper", "--backend", "cairo"});
    draw(folder, GetParam(), "page.pdf", {"--paper"});
    draw(folder, GetParam(), "native.pdf", {"--paper", "--backend", "native", "--set", "page.bleed=0"});
  }

  /// An attribute of the root of an SVG file.
  std::string root_attribute(const std::string& file, const std::string& name) const {
    std::string value = run_in(folder, {"xmllint", "--xpath", "string(/*/@" + name + ")", file}).out;
    while (value.ends_with('\n')) value.pop_back();
    return value;
  }

  /// What the root of an SVG file says, in mm.
  PageSize page_size(const std::string& file) const {
    const std::string size = root_attribute(file, "width") + ' ' + root_attribute(file, "height");
    PageSize page;
    char after = '\0';
    EXPECT_EQ(std::sscanf((size + '.').c_str(), "%lfmm %lfmm%c", &page.width_mm, &page.height_mm, &after), 3) << size;
    EXPECT_EQ(after, '.') << size;
    return page;
  }

  TemporaryFolder folder;
};

TEST_P(Shipped, LooksTheSameOnAScreen) {
  draw(folder, GetParam(), "native.svg", {"--paper"});
  const int dots = whole_dots(page_size("native.svg"));
  draw_all({"--size", std::to_string(dots) + "px"});
  const GreyPicture ours = read_png(folder.file("ours.png"));
  EXPECT_EQ(std::max(ours.width, ours.height), dots);
  const DrawnAs as = in_pixels(ours);
  expect_alike(ours, seen_by_rsvg(folder, "native", as));
  expect_alike(ours, seen_by_rsvg(folder, "cairo", as));
  // MuPDF rounds every edge outwards to 1/17 of a dot, which makes a line of one dot 2 % wider: its ink is compared
  // where a line has more dots, in print.
  for (const char* pdf : {"page", "native"}) {
    SCOPED_TRACE(pdf);
    expect_small(rmse(ours, seen_by_mupdf(folder, pdf, as)), ours);
  }
}

TEST_P(Shipped, LooksTheSameThroughOurRasterizer) {
  // Not smaller: lines of a fifth of a pixel are Cairo's weak side, by 1 % of the ink, and two pens within one pixel
  // are laid over each other by its share of both, which no large picture shows.
  for (const char* size : {"800px", "1600px"}) {
    draw(folder, GetParam(), "cairo.png", {"--size", size});
    draw(folder, GetParam(), "native.png", {"--size", size, "--backend", "native"});
    expect_alike(read_png(folder.file("cairo.png")), read_png(folder.file("native.png")));
    run_silently_in(folder, {"pngcheck", "-q", "native.png"});
  }
}

// Each at its own idea of 300 dots to the inch: a wrong size would show, too.
TEST_P(Shipped, LooksTheSameInPrint) {
  draw_all({"--dpi", "300"});
  const GreyPicture ours = read_png(folder.file("ours.png"));
  const DrawnAs as = in_dots_per_inch(300);
  expect_alike(ours, seen_by_rsvg(folder, "native", as));
  expect_alike(ours, seen_by_rsvg(folder, "cairo", as));
  expect_alike(ours, seen_by_mupdf(folder, "page", as));
  expect_alike(ours, seen_by_mupdf(folder, "native", as));
}

TEST_P(Shipped, IsCleanForPrograms) {
  draw_all({});
  run_silently_in(folder, {"xmllint", "--noout", "native.svg", "cairo.svg"});
  draw(folder, GetParam(), "bleed.pdf", {"--backend", "native", "--set", "page.bleed=3mm"});
  for (const std::string pdf : {"page.pdf", "native.pdf", "bleed.pdf"}) {
    SCOPED_TRACE(pdf);
    EXPECT_NE(run_in(folder, {"qpdf", "--check", pdf}).out.find("No syntax or stream encoding errors found"),
              std::string::npos);
    const Finished info = run_in(folder, {"mutool", "info", pdf});
    EXPECT_EQ(info.err, "");
    EXPECT_NE(info.out.find("Pages: 1\n"), std::string::npos) << info.out;
    // Letters beyond ASCII are written in UTF-16.
    EXPECT_TRUE(info.out.find("/Title(") != std::string::npos || info.out.find("/Title<FEFF") != std::string::npos)
        << info.out;
    EXPECT_EQ(info.out.find("Images ("), std::string::npos) << "a picture of dots in the PDF\n" << info.out;
    run_silently_in(folder, {"pdftocairo", "-png", "-r", "30", pdf, "poppler"});
  }
  run_silently_in(folder, {"pngcheck", "-q", "ours.png"});
}

TEST_P(Shipped, HasItsTrueSizeInEveryFormat) {
  draw_all({"--dpi", "100"});
  const PageSize page = page_size("native.svg");
  for (const std::string side : {"width", "height"}) {
    EXPECT_EQ(root_attribute("cairo.svg", side), root_attribute("native.svg", side));
  }

  for (const std::string pdf : {"page.pdf", "native.pdf"}) {
    SCOPED_TRACE(pdf);
    const std::string pages = run_in(folder, {"mutool", "pages", pdf}).out;
    const std::size_t at = pages.find("<MediaBox");
    ASSERT_NE(at, std::string::npos) << pages;
    double left = -1.0;
    double bottom = -1.0;
    double right = 0.0;
    double top = 0.0;
    ASSERT_EQ(std::sscanf(pages.c_str() + at, "<MediaBox l=\"%lf\" b=\"%lf\" r=\"%lf\" t=\"%lf\"", &left, &bottom,
                          &right, &top),
              4)
        << pages;
    EXPECT_EQ(left, 0.0);
    EXPECT_EQ(bottom, 0.0);
    EXPECT_NEAR(right, page.width_mm * 72.0 / mm_per_inch, 1e-3);
    EXPECT_NEAR(top, page.height_mm * 72.0 / mm_per_inch, 1e-3);
  }

  const GreyPicture ours = read_png(folder.file("ours.png"));
  EXPECT_NEAR(ours.width, page.width_mm / mm_per_inch * 100.0, 0.51);
  EXPECT_NEAR(ours.height, page.height_mm / mm_per_inch * 100.0, 0.51);
  const std::string chunks = run_in(folder, {"pngcheck", "-v", "ours.png"}).out;
  EXPECT_NE(chunks.find("3937x3937 pixels/meter (100 dpi)"), std::string::npos) << chunks;
}

INSTANTIATE_TEST_SUITE_P(Presets, Shipped, testing::ValuesIn(shipped_presets()), [](const auto& preset) {
  std::string name = preset.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(TrueSize, OfAnA4PageIsIts) {
  const TemporaryFolder folder;
  draw(folder, "koch", "page.svg", {"--page", "a4", "--landscape"});
  EXPECT_EQ(run_in(folder, {"xmllint", "--xpath", "string(/*/@width)", "page.svg"}).out, "297mm\n");
  EXPECT_EQ(run_in(folder, {"xmllint", "--xpath", "string(/*/@viewBox)", "page.svg"}).out, "0 0 297 210\n");
}

TEST(GreyPicture, DifferencesAndInkAreThoseByHand) {
  const GreyPicture a{2, 2, {255, 255, 0, 204}};
  const GreyPicture b{2, 2, {255, 247, 0, 204}};
  EXPECT_DOUBLE_EQ(rmse(a, b), 4.0);
  EXPECT_DOUBLE_EQ(ink(a), 1.2);
  EXPECT_EQ(top_left(a, 1, 2).grey, (std::vector<std::uint8_t>{255, 0}));
  EXPECT_EQ(moved({3, 2, {1, 2, 3, 4, 5, 6}}, 1).grey, (std::vector<std::uint8_t>{2, 3, 1, 5, 6, 4}));
}

}  // namespace
}  // namespace burin::test
