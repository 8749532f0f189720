#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <png.h>

namespace burin::test {

/// How a PNG for a test is stored.
struct MadePng {
  int width = 1;
  int height = 1;
  int colour_type = PNG_COLOR_TYPE_RGB;
  int bits = 8;
  bool interlaced = false;
  std::vector<png_color> palette{};
  std::vector<std::uint8_t> palette_alpha{};
  bool has_transparent_colour = false;
  png_color_16 transparent_colour{};
};

/// The file that libpng makes of it. `sample` gives each pixel's channels, from 0 to 2^bits - 1. Throws when libpng
/// refuses.
inline std::string made_png(const MadePng& made,
                            const std::function<std::uint16_t(int x, int y, int channel)>& sample) {
  std::string bytes;
  const auto refuse = [](png_structp, png_const_charp message) { throw std::runtime_error(message); };
  const auto append = [](png_structp png, png_bytep from, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(from), count);
  };
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, append, [](png_structp) {});
  png_set_IHDR(png, info, static_cast<std::uint32_t>(made.width), static_cast<std::uint32_t>(made.height), made.bits,
               made.colour_type, made.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!made.palette.empty()) png_set_PLTE(png, info, made.palette.data(), static_cast<int>(made.palette.size()));
  if (!made.palette_alpha.empty()) {
    png_set_tRNS(png, info, made.palette_alpha.data(), static_cast<int>(made.palette_alpha.size()), nullptr);
  }
  if (made.has_transparent_colour) png_set_tRNS(png, info, nullptr, 0, &made.transparent_colour);
  png_write_info(png, info);

  const int channels = png_get_channels(png, info);
  const std::size_t row_bytes = png_get_rowbytes(png, info);
  std::vector<std::uint8_t> pixels(row_bytes * static_cast<std::size_t>(made.height));
  std::vector<std::uint8_t*> rows;
  for (int y = 0; y < made.height; ++y) {
    std::uint8_t* const row = &pixels[row_bytes * static_cast<std::size_t>(y)];
    rows.push_back(row);
    for (int i = 0; i < made.width * channels; ++i) {
      const unsigned value = sample(i / channels, y, i % channels);
      const int bit = i * made.bits;
      if (made.bits == 16) {
        row[bit / 8] = static_cast<std::uint8_t>(value >> 8U);
        row[bit / 8 + 1] = static_cast<std::uint8_t>(value);
      } else {
        row[bit / 8] =
            static_cast<std::uint8_t>(row[bit / 8] | value << static_cast<unsigned>(8 - made.bits - bit % 8));
      }
    }
  }
  png_write_image(png, rows.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

}  // namespace burin::test
