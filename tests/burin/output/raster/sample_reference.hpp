#pragma once

#include <vector>

#include <burin/output/raster/ink.hpp>
#include <burin/path/sheet.hpp>

/// What is ink and what is not, by looking at one sample after the other: slow, and written from the definitions of
/// strokes and fills, not from the rasterizer.
namespace burin::test {

using output::raster::Ink;
using output::raster::PixelBox;
using output::raster::Point;
using output::raster::Samples;

struct ReferenceStroke {
  std::vector<Point> points;
  bool closed = false;
  double half_width = 512.0;  ///< units
  Cap cap = Cap::round;
  Join join = Join::round;
  double miter_limit = 4.0;

  /// The same stroke; no point follows itself.
  ReferenceStroke without_repeats() const;
  /// Pre: no point follows itself.
  bool covers(Point sample) const;
};

struct ReferenceFill {
  std::vector<std::vector<Point>> contours;
  bool evenodd = false;

  bool covers(Point sample) const;
};

/// The position of a sample, from the definition of the rotated grid.
Point sample_position(int i, int j, int row, int column);

/// All samples of a part of the page, pixel by pixel.
template <class Covers>
std::vector<Samples> reference_samples(const PixelBox& part, const Covers& covers) {
  std::vector<Samples> all;
  for (int j = part.top; j < part.bottom; ++j) {
    for (int i = part.left; i < part.right; ++i) {
      Samples samples = 0;
      for (int bit = 0; bit < 64; ++bit) {
        if (covers(sample_position(i, j, bit / 8, bit % 8))) samples |= Samples{1} << bit;
      }
      all.push_back(samples);
    }
  }
  return all;
}

/// What the rasterizer has, in the same order; `part` may be smaller than the ink's.
std::vector<Samples> samples_of(Ink& ink, const PixelBox& part);

/// In how many samples two pictures differ.
int differing_samples(const std::vector<Samples>& a, const std::vector<Samples>& b);

}  // namespace burin::test
