#include "renderers/grey_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include <png.h>

namespace burin::test {
namespace {

std::uint8_t grey_of(const std::uint8_t* rgb) {
  return static_cast<std::uint8_t>((2126 * rgb[0] + 7152 * rgb[1] + 722 * rgb[2] + 5000) / 10000);
}

}  // namespace

GreyPicture read_png(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) throw std::runtime_error(path + ": " + image.message);
  image.format = PNG_FORMAT_RGB;
  const png_color white{255, 255, 255};
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, &white, rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(path + ": " + image.message);
  }
  GreyPicture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.grey.reserve(rgb.size() / 3);
  for (std::size_t i = 0; i < rgb.size(); i += 3) picture.grey.push_back(grey_of(&rgb[i]));
  return picture;
}

double rmse(const GreyPicture& a, const GreyPicture& b) {
  if (a.width != b.width || a.height != b.height) throw std::invalid_argument("pictures of two sizes");
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < a.grey.size(); ++i) {
    const int difference = a.grey[i] - b.grey[i];
    sum += difference * difference;
  }
  return std::sqrt(static_cast<double>(sum) / static_cast<double>(a.grey.size()));
}

GreyPicture top_left(const GreyPicture& picture, int width, int height) {
  GreyPicture part{width, height, {}};
  for (int y = 0; y < height; ++y) {
    const auto row = picture.grey.begin() + std::ptrdiff_t{picture.width} * y;
    part.grey.insert(part.grey.end(), row, row + width);
  }
  return part;
}

double ink(const GreyPicture& picture) {
  const int paper = picture.grey.at(0);
  std::int64_t sum = 0;
  for (const std::uint8_t grey : picture.grey) sum += paper - grey;
  return static_cast<double>(sum) / 255.0;
}

GreyPicture moved(const GreyPicture& picture, int columns) {
  GreyPicture other = picture;
  for (int y = 0; y < picture.height; ++y) {
    const auto row = other.grey.begin() + std::ptrdiff_t{picture.width} * y;
    std::rotate(row, row + columns, row + picture.width);
  }
  return other;
}

}  // namespace burin::test
