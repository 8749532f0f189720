#include <array>
#include <cstdio>
#include <cstdlib>
#include <jpeglib.h>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/data/jpeg.hpp>

namespace burin::data {
namespace {

/// A JPEG of flat blocks of 16 x 16 pixels, which survive compression; red, green, blue and white in the corners.
std::string made_jpeg(int components, int orientation = 0, const std::string& endian = "II") {
  constexpr int width = 32;
  constexpr int height = 48;
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = width;
  info.image_height = height;
  info.input_components = components;
  info.in_color_space = components == 1 ? JCS_GRAYSCALE : components == 3 ? JCS_RGB : JCS_CMYK;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 100, TRUE);
  jpeg_start_compress(&info, TRUE);
  if (orientation > 0) {
    const bool big = endian == "MM";
    const auto two = [&](int v) {
      return big ? std::string{'\0', static_cast<char>(v)} : std::string{static_cast<char>(v), '\0'};
    };
    const std::string tag = big ? std::string("\x01\x12") : std::string("\x12\x01");
    const std::string eight = big ? std::string("\0\0\0\x08", 4) : std::string("\x08\0\0\0", 4);
    const std::string one = big ? std::string("\0\0\0\x01", 4) : std::string("\x01\0\0\0", 4);
    const std::string exif = std::string("Exif\0\0", 6) + endian + two(42) + eight + two(1) + tag + two(3) + one +
                             two(orientation) + two(0) + std::string(4, '\0');
    jpeg_write_marker(&info, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(exif.data()),
                      static_cast<unsigned>(exif.size()));
  }
  for (int y = 0; y < height; ++y) {
    std::vector<unsigned char> row;
    for (int x = 0; x < width; ++x) {
      const bool right = x >= 16;
      const bool low = y >= 32;
      const std::array<unsigned char, 4> colour{
          static_cast<unsigned char>(!right || low ? (right || !low ? 255 : 0) : 0),
          static_cast<unsigned char>(right ? 255 : 0), static_cast<unsigned char>(low ? 255 : 0), 255};
      for (int c = 0; c < components; ++c) row.push_back(colour[static_cast<std::size_t>(c)]);
    }
    JSAMPROW rows[1] = {row.data()};
    jpeg_write_scanlines(&info, rows, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  std::string file(reinterpret_cast<const char*>(bytes), size);
  std::free(bytes);
  return file;
}

/// "red", "green", "blue", "white" or something else: what a pixel is nearest to.
std::string colour(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  const std::string bits{p[0] > 127 ? '1' : '0', p[1] > 127 ? '1' : '0', p[2] > 127 ? '1' : '0'};
  if (bits == "100") return "red";
  if (bits == "010") return "green";
  if (bits == "001") return "blue";
  return bits == "111" ? "white" : bits;
}

/// The colours of the corners, clockwise from the top left.
std::string corners(const Image& image) {
  const int right = image.width - 8;
  const int low = image.height - 8;
  return colour(image, 8, 8) + ' ' + colour(image, right, 8) + ' ' + colour(image, right, low) + ' ' +
         colour(image, 8, low);
}

TEST(Jpeg, ColoursAndGrey) {
  const Result<Image> image = read_jpeg(made_jpeg(3), "a.jpg");
  ASSERT_TRUE(image.ok()) << problems_text(image.problems());
  EXPECT_EQ(image->width, 32);
  EXPECT_EQ(image->height, 48);
  EXPECT_EQ(corners(*image), "red green white blue");
  EXPECT_EQ(image->pixel(3, 3)[3], 255);
  const Result<Image> grey = read_jpeg(made_jpeg(1), "a.jpg");
  ASSERT_TRUE(grey.ok());
  EXPECT_NEAR(grey->pixel(4, 4)[0], 255, 2);
  EXPECT_EQ(grey->pixel(4, 4)[0], grey->pixel(4, 4)[2]);
  EXPECT_NEAR(grey->pixel(28, 4)[1], 0, 2);
}

TEST(Jpeg, EveryExifTurnIsUndone) {
  // As the table of the standard tells where row 0 and column 0 of the file are.
  const std::array<std::string, 9> upright{"",
                                           "red green white blue",
                                           "green red blue white",
                                           "white blue red green",
                                           "blue white green red",
                                           "red blue white green",
                                           "blue red green white",
                                           "white green red blue",
                                           "green white blue red"};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    for (const char* endian : {"II", "MM"}) {
      const Result<Image> image = read_jpeg(made_jpeg(3, orientation, endian), "a.jpg");
      ASSERT_TRUE(image.ok());
      EXPECT_EQ(image->width, orientation < 5 ? 32 : 48);
      EXPECT_EQ(corners(*image), upright[static_cast<std::size_t>(orientation)]) << orientation;
    }
  }
}

TEST(Jpeg, WhatIsNoneIsAProblem) {
  EXPECT_FALSE(read_jpeg("", "a.jpg").ok());
  EXPECT_FALSE(read_jpeg("\x89PNG", "a.jpg").ok());
  const Result<Image> inks = read_jpeg(made_jpeg(4), "a.jpg");
  ASSERT_FALSE(inks.ok());
  EXPECT_NE(inks.problems()[0].message.find("4 inks"), std::string::npos);
  const std::string whole = made_jpeg(3, 6);
  for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
    EXPECT_FALSE(read_jpeg(whole.substr(0, size), "a.jpg").ok()) << size;
  }
}

TEST(Jpeg, TooLargeIsToldBeforeItIsRead) {
  std::string bytes = made_jpeg(3);
  const std::size_t frame = bytes.find("\xFF\xC0");
  ASSERT_NE(frame, std::string::npos);
  bytes.replace(frame + 5, 4, "\xFD\xE8\xFD\xE8");
  const Result<Image> image = read_jpeg(bytes, "a.jpg");
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.problems()[0].trouble, Trouble::limit);
}

}  // namespace
}  // namespace burin::data
