#include <gtest/gtest.h>

#include <burin/output/raster/polygon_fill.hpp>

#include "sample_reference.hpp"
#include "support/random_paths.hpp"

namespace burin::test {
namespace {

using namespace output::raster;

constexpr PixelBox part{0, 0, 32, 24};

std::vector<Samples> filled(const ReferenceFill& shape, const PixelBox& some = part) {
  Ink ink(some);
  PolygonFill polygon;
  for (const std::vector<Point>& contour : shape.contours) polygon.add_contour(contour);
  ink.add(polygon, shape.evenodd);
  return samples_of(ink, some);
}

ReferenceFill random_fill(Dice& dice) {
  ReferenceFill shape;
  shape.evenodd = dice.below(2) == 0;
  const std::size_t contours = 1 + dice.below(3);
  for (std::size_t c = 0; c < contours; ++c) {
    std::vector<Point> points;
    const std::size_t count = 1 + dice.below(12);
    for (std::size_t k = 0; k < count; ++k) {
      points.push_back({static_cast<std::int32_t>(1024.0 * dice.between(-10, 42)),
                        static_cast<std::int32_t>(1024.0 * dice.between(-10, 34))});
      if (k > 0 && dice.below(5) == 0) points.back().x = points[k - 1].x;
      if (k > 0 && dice.below(5) == 0) points.back().y = points[k - 1].y;
    }
    shape.contours.push_back(points);
  }
  return shape;
}

TEST(Fill, HasExactlyTheSamplesInside) {
  Dice dice(3);
  for (int turn = 0; turn < 60; ++turn) {
    const ReferenceFill shape = random_fill(dice);
    const auto reference = reference_samples(part, [&](Point p) { return shape.covers(p); });
    EXPECT_EQ(differing_samples(filled(shape), reference), 0) << "turn " << turn;
  }
}

TEST(Fill, WithEdgesThroughSamplesGivesEachSampleToOneSide) {
  // Two rectangles side by side, whose common edge goes through samples: together they have each of them once.
  const std::int32_t x = 8 * 1024 + sample_x(3, 5);
  const ReferenceFill left{{{{2048, 2048}, {x, 2048}, {x, 9000}, {2048, 9000}}}, false};
  const ReferenceFill right{{{{x, 2048}, {20000, 2048}, {20000, 9000}, {x, 9000}}}, false};
  const ReferenceFill both{{{{2048, 2048}, {20000, 2048}, {20000, 9000}, {2048, 9000}}}, false};
  const std::vector<Samples> a = filled(left);
  const std::vector<Samples> b = filled(right);
  const std::vector<Samples> all = filled(both);
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(a[k] & b[k], 0U);
    EXPECT_EQ(a[k] | b[k], all[k]);
  }
}

TEST(Fill, InPartsIsTheSameAsAtOnce) {
  Dice dice(4);
  for (int turn = 0; turn < 20; ++turn) {
    const ReferenceFill shape = random_fill(dice);
    const std::vector<Samples> all = filled(shape);
    const PixelBox some{16, 8, 32, 16};
    const std::vector<Samples> part_of_it = filled(shape, some);
    for (int j = some.top; j < some.bottom; ++j) {
      for (int i = some.left; i < some.right; ++i) {
        EXPECT_EQ(part_of_it[static_cast<std::size_t>((j - some.top) * some.width() + i - some.left)],
                  all[static_cast<std::size_t>(j * part.width() + i)]);
      }
    }
  }
}

TEST(Fill, OfALargeSquareIsFull) {
  const ReferenceFill shape{{{{-100'000'000, -100'000'000},
                              {100'000'000, -100'000'000},
                              {100'000'000, 100'000'000},
                              {-100'000'000, 100'000'000}}},
                            false};
  for (const Samples samples : filled(shape)) EXPECT_EQ(samples, all_samples);
}

}  // namespace
}  // namespace burin::test
