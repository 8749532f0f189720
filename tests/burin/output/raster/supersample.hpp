#pragma once

#include <cstdint>
#include <vector>

#include <burin/geom/vec2.hpp>

namespace burin::test {

struct Line {
  Vec2 from;
  Vec2 to;
};

/// How much of each pixel lines with round ends cover, by 32 x 32 samples a pixel: 0 to 1024, row by row. `lines` and
/// `width_px` in pixels. Slow and simple; memory: 128 bytes for each pixel of 16 rows.
std::vector<std::uint16_t> supersampled(const std::vector<Line>& lines, double width_px, int width, int height);

/// The mean difference between a picture in black (0) on white (255) and that coverage, of 255, over the pixels that
/// have ink in either.
double mean_difference(const std::vector<std::uint8_t>& grey, const std::vector<std::uint16_t>& coverage);

}  // namespace burin::test
