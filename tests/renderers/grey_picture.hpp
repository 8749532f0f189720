#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Comparing two renderings of the same page.
namespace burin::test {

/// A picture in 8-bit grey, row by row from the top.
struct GreyPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;
};

/// Reads a PNG file of any kind; transparency is laid on white, colours are weighed by Rec. 709 as they are stored.
/// Throws std::runtime_error when it cannot be read.
GreyPicture read_png(const std::string& path);

/// Root mean square difference of two pictures of one size, in steps of 255. Throws std::invalid_argument for two
/// sizes.
double rmse(const GreyPicture& a, const GreyPicture& b);

/// What lies within `width` and `height`, which are at most the picture's.
GreyPicture top_left(const GreyPicture& picture, int width, int height);

/// How much darker than its top left pixel, the bare paper, a picture is: the sum over all pixels, in pixels of black.
double ink(const GreyPicture& picture);

/// The picture with its first columns, of which it has more, behind its last.
GreyPicture moved(const GreyPicture& picture, int columns);

}  // namespace burin::test
