#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/primitives/pixels.hpp>

namespace burin::primitives {
namespace {

Bitmap bitmap(const std::string& text) {
  const Result<Bitmap> read = bitmap_from_text(text, {"p.toml", 3, 1});
  EXPECT_TRUE(read.ok()) << problems_text(read.problems());
  return read ? *read : Bitmap{};
}

using Contours = std::vector<std::vector<Vec2>>;

double area_of(const std::vector<Vec2>& contour) {
  double area = 0.0;
  for (std::size_t i = 0; i < contour.size(); ++i) area += 0.5 * cross(contour[i], contour[(i + 1) % contour.size()]);
  return area;
}

/// How often the contours go round a point.
int winding(const Contours& contours, Vec2 at) {
  int turns = 0;
  for (const std::vector<Vec2>& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2 p = contour[i];
      const Vec2 q = contour[(i + 1) % contour.size()];
      if (p.x > at.x && p.y <= at.y && q.y > at.y) ++turns;
      if (p.x > at.x && q.y <= at.y && p.y > at.y) --turns;
    }
  }
  return turns;
}

TEST(Pixels, OneIsASquare) {
  EXPECT_EQ(outline_of(bitmap("#")), (Contours{{{1, -1}, {1, 0}, {0, 0}, {0, -1}}}));
  EXPECT_TRUE(outline_of(bitmap("...\n.-_")).empty());
}

TEST(Pixels, StraightEdgesHaveNoPointsBetween) {
  EXPECT_EQ(outline_of(bitmap("###\n###")), (Contours{{{3, -2}, {3, 0}, {0, 0}, {0, -2}}}));
}

TEST(Pixels, HolesRunTheOtherWay) {
  const Contours contours = outline_of(bitmap("###\n#.#\n###"));
  ASSERT_EQ(contours.size(), 2U);
  EXPECT_EQ(area_of(contours[0]) + area_of(contours[1]), 8.0);
  EXPECT_EQ(std::min(area_of(contours[0]), area_of(contours[1])), -1.0);
}

TEST(Pixels, TouchingAtACornerStaysApart) {
  const Contours two = outline_of(bitmap("#.\n.#"));
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(area_of(two[0]), 1.0);
  EXPECT_EQ(area_of(two[1]), 1.0);
  EXPECT_EQ(outline_of(bitmap(".#\n#.")).size(), 2U);
  // A hole that touches the outside at a corner: one contour that meets itself there.
  const Contours pinched = outline_of(bitmap("###\n#.#\n##."));
  double area = 0.0;
  for (const std::vector<Vec2>& contour : pinched) area += area_of(contour);
  EXPECT_EQ(area, 7.0);
}

TEST(Pixels, RandomBitmapsAreTheirOutlines) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Bitmap made{static_cast<int>(1 + random_bits(seed, 1) % 9), static_cast<int>(1 + random_bits(seed, 2) % 9), {}};
    int set = 0;
    for (int i = 0; i < made.width * made.height; ++i) {
      made.set.push_back(random_bits(seed, 3, static_cast<std::uint64_t>(i)) % 100 < 20 + seed % 70);
      set += made.set.back() ? 1 : 0;
    }
    const Contours contours = outline_of(made);
    double area = 0.0;
    std::set<std::pair<std::pair<double, double>, std::pair<double, double>>> edges;
    for (const std::vector<Vec2>& contour : contours) {
      area += area_of(contour);
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Vec2 p = contour[i];
        const Vec2 q = contour[(i + 1) % contour.size()];
        EXPECT_TRUE((p.x == q.x) != (p.y == q.y)) << "along the grid";
        EXPECT_TRUE(edges.insert({{p.x, p.y}, {q.x, q.y}}).second) << "no edge twice";
      }
    }
    EXPECT_EQ(area, set) << seed;
    for (int row = -1; row <= made.height; ++row) {
      for (int column = -1; column <= made.width; ++column) {
        EXPECT_EQ(winding(contours, {column + 0.5, -row - 0.5}), made.at(column, row) ? 1 : 0)
            << seed << ": " << column << ' ' << row;
      }
    }
  }
}

TEST(Pixels, TheAnchorIsAPixelsMiddle) {
  const std::optional<Primitive> figure =
      primitive_of(bitmap("..#\n.##\n####"), PixelPlace{2, 0}, Paint::fill_nonzero, "step");
  ASSERT_TRUE(figure.has_value());
  const Box2 box = figure->figure->drawing().bounds();
  EXPECT_NEAR(box.low.x, -2.5 / 4.0, 1e-12);
  EXPECT_NEAR(box.high.x, 1.5 / 4.0, 1e-12);
  EXPECT_NEAR(box.high.y, 0.5 / 4.0, 1e-12);
  EXPECT_NEAR(box.low.y, -2.5 / 4.0, 1e-12);
  EXPECT_EQ(figure->figure->drawing().paths().at(0).head.paint, Paint::fill_nonzero);
  EXPECT_TRUE(figure->figure->drawing().paths().at(0).head.closed);
  const std::optional<Primitive> centred = primitive_of(bitmap("\n  ##\n"), std::nullopt, Paint::stroke, "bar");
  ASSERT_TRUE(centred.has_value());
  EXPECT_NEAR(centred->figure->drawing().bounds().low.x, -0.5, 1e-12);
  EXPECT_NEAR(centred->figure->drawing().bounds().high.y, 0.25, 1e-12);
  EXPECT_FALSE(primitive_of(bitmap(".."), std::nullopt, Paint::stroke, "nothing").has_value());
}

TEST(Pixels, TextThatIsNoBitmap) {
  const Result<Bitmap> wrong = bitmap_from_text("##\n#o", {"p.toml", 3, 1});
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.problems()[0].where.line, 3);
  EXPECT_NE(wrong.problems()[0].message.find("line 2 of the bitmap, character 2"), std::string::npos);
  EXPECT_FALSE(bitmap_from_text(std::string(1'100'000, '#'), {}).ok());
}

TEST(Pixels, DarkOpaquePixelsOfAPictureAreSet) {
  data::Image image{4, 1, {0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 0, 255, 0, 0, 255}};
  const Result<Bitmap> read = bitmap_from_image(image, "a.png");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->set, (std::vector<bool>{true, false, false, true}));
}

}  // namespace
}  // namespace burin::primitives
