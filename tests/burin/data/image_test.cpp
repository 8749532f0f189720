#include <array>
#include <cmath>
#include <string>
#include <sys/resource.h>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/data/image.hpp>

#include "made_png.hpp"

namespace burin::data {
namespace {

using test::made_png;
using test::MadePng;

using Pixel = std::array<int, 4>;

Pixel pixel(const Image& image, int x, int y) {
  const std::uint8_t* const at = image.pixel(x, y);
  return {at[0], at[1], at[2], at[3]};
}

Image read(const std::string& bytes) {
  const Result<Image> image = read_png(bytes, "a.png");
  EXPECT_TRUE(image.ok()) << (image.ok() ? "" : problems_text(image.problems()));
  return image.ok() ? *image : Image{1, 1, {0, 0, 0, 0}};
}

Problem problem(const std::string& bytes) {
  const Result<Image> image = read_png(bytes, "a.png");
  EXPECT_FALSE(image.ok());
  return image.ok() ? Problem{} : image.problems().front();
}

/// Different in every pixel and channel, as far as the bits allow.
std::uint16_t pattern(int x, int y, int channel, int bits) {
  const unsigned value = static_cast<unsigned>(x * 7919 + y * 104729 + channel * 15485863 + x * y * 31);
  return static_cast<std::uint16_t>(value & ((1U << static_cast<unsigned>(bits)) - 1U));
}

/// What 8 bits make of a sample: the nearest of 256 steps.
int in_8_bits(unsigned sample, int bits) {
  return static_cast<int>(std::floor(sample * 255.0 / ((1U << static_cast<unsigned>(bits)) - 1U) + 0.5));
}

struct Kind {
  int colour_type;
  int bits;
};

class EveryKind : public ::testing::TestWithParam<std::tuple<Kind, bool>> {};

TEST_P(EveryKind, GivesItsColours) {
  const auto& [kind, interlaced] = GetParam();
  const bool grey = (kind.colour_type & PNG_COLOR_MASK_COLOR) == 0;
  const bool alpha = (kind.colour_type & PNG_COLOR_MASK_ALPHA) != 0;
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {17, 9}, {64, 2}}) {
    const MadePng made{width, height, kind.colour_type, kind.bits, interlaced};
    const auto sample = [bits = kind.bits](int x, int y, int c) { return pattern(x, y, c, bits); };
    const Image image = read(made_png(made, sample));
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    ASSERT_EQ(image.rgba.size(), static_cast<std::size_t>(4 * width * height));
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto channel = [&, bits = kind.bits](int c) { return in_8_bits(sample(x, y, c), bits); };
        const Pixel expected{channel(0), channel(grey ? 0 : 1), channel(grey ? 0 : 2),
                             alpha ? channel(grey ? 1 : 3) : 255};
        ASSERT_EQ(pixel(image, x, y), expected) << x << "," << y << " of " << width << "x" << height;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Png, EveryKind,
    ::testing::Combine(::testing::Values(Kind{PNG_COLOR_TYPE_GRAY, 1}, Kind{PNG_COLOR_TYPE_GRAY, 2},
                                         Kind{PNG_COLOR_TYPE_GRAY, 4}, Kind{PNG_COLOR_TYPE_GRAY, 8},
                                         Kind{PNG_COLOR_TYPE_GRAY, 16}, Kind{PNG_COLOR_TYPE_GRAY_ALPHA, 8},
                                         Kind{PNG_COLOR_TYPE_GRAY_ALPHA, 16}, Kind{PNG_COLOR_TYPE_RGB, 8},
                                         Kind{PNG_COLOR_TYPE_RGB, 16}, Kind{PNG_COLOR_TYPE_RGB_ALPHA, 8},
                                         Kind{PNG_COLOR_TYPE_RGB_ALPHA, 16}),
                       ::testing::Bool()));

TEST(Png, APaletteGivesItsColoursAndTheirAlpha) {
  for (const int bits : {1, 2, 4, 8}) {
    for (const bool interlaced : {false, true}) {
      MadePng made{19, 7, PNG_COLOR_TYPE_PALETTE, bits, interlaced};
      made.palette = {{255, 99, 71}, {0, 0, 128}};
      made.palette_alpha = {40};
      const Image image = read(made_png(made, [](int x, int y, int) { return pattern(x, y, 0, 1); }));
      for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 19; ++x) {
          const Pixel expected = pattern(x, y, 0, 1) == 0 ? Pixel{255, 99, 71, 40} : Pixel{0, 0, 128, 255};
          ASSERT_EQ(pixel(image, x, y), expected) << bits << " bits, " << x << "," << y;
        }
      }
    }
  }
}

TEST(Png, ATransparentColourIsTransparentAndItsNeighbourIsNot) {
  MadePng grey{2, 1, PNG_COLOR_TYPE_GRAY, 16};
  grey.has_transparent_colour = true;
  grey.transparent_colour.gray = 0x1234;
  const Image image = read(made_png(grey, [](int x, int, int) { return static_cast<std::uint16_t>(0x1234 + x); }));
  EXPECT_EQ(pixel(image, 0, 0), (Pixel{0x12, 0x12, 0x12, 0}));
  EXPECT_EQ(pixel(image, 1, 0), (Pixel{0x12, 0x12, 0x12, 255}));
}

// Damaged and hostile files.

std::string small_file(bool interlaced = false) {
  const MadePng made{33, 21, PNG_COLOR_TYPE_RGB_ALPHA, 8, interlaced};
  return made_png(made, [](int x, int y, int c) { return pattern(x, y, c, 8); });
}

TEST(Png, WhatIsNoPngIsToldSo) {
  for (const std::string& bytes : {std::string(), std::string("\x89PN"), std::string("\xFF\xD8\xFF\xE0 JFIF"),
                                   std::string("burin = 1\n"), std::string(100, '\0')}) {
    EXPECT_EQ(problem(bytes).message, "is no PNG: it does not begin as one");
    EXPECT_EQ(problem(bytes).where.file, "a.png");
  }
}

TEST(Png, CutAnywhereItIsRefused) {
  for (const bool interlaced : {false, true}) {
    const std::string whole = small_file(interlaced);
    for (std::size_t length = 8; length < whole.size(); ++length) {
      ASSERT_EQ(problem(whole.substr(0, length)).message,
                "is cut short: the PNG goes on where the file ends; copy it again")
          << length << " of " << whole.size();
    }
  }
}

TEST(Png, WhatFollowsTheEndIsLeftAside) {
  EXPECT_EQ(read(small_file() + "more"), read(small_file()));
}

TEST(Png, EveryChangedBitOfItsChunksIsFound) {
  const std::string whole = small_file();
  const Image image = read(whole);
  int refused = 0;
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += 3) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ static_cast<char>(1U << bit % 8));
    const Result<Image> read = read_png(damaged, "a.png");
    if (!read) {
      ++refused;
    } else {
      ASSERT_EQ(*read, image) << "bit " << bit << " changed the picture unseen";
    }
  }
  EXPECT_GT(refused, static_cast<int>(whole.size()) * 8 / 3 * 9 / 10);
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + 4; ++i) number = number << 8U | static_cast<std::uint8_t>(bytes[i]);
  return number;
}

void put_number(std::string& bytes, std::size_t at, std::uint32_t number) {
  for (std::size_t i = 4; i > 0; --i) {
    bytes[at + i - 1] = static_cast<char>(number & 0xFFU);
    number >>= 8U;
  }
}

/// The file with the checksum of each chunk made right, so that a reader gets to what is in it.
std::string with_right_checksums(std::string file) {
  for (std::size_t chunk = 8; chunk + 12 <= file.size();) {
    const std::size_t end = chunk + 8 + number_at(file, chunk);
    if (end + 4 > file.size()) break;
    std::uint32_t crc = 0xFFFFFFFFU;
    for (std::size_t i = chunk + 4; i < end; ++i) {
      crc ^= static_cast<std::uint8_t>(file[i]);
      for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xEDB88320U : crc >> 1U;
    }
    put_number(file, end, ~crc);
    chunk = end + 4;
  }
  return file;
}

/// A file that claims this size and has the pixels of another.
std::string claiming(std::uint32_t width, std::uint32_t height) {
  std::string file = small_file();
  put_number(file, 16, width);
  put_number(file, 20, height);
  return with_right_checksums(file);
}

TEST(Png, SizesThatNobodyCanHoldAreALimit) {
  EXPECT_EQ(read(claiming(33, 21)), read(small_file()));
  for (const auto& [width, height] :
       {std::pair{0x7FFFFFFFU, 0x7FFFFFFFU}, {0x7FFFFFFFU, 1U}, {8193U, 8192U}, {1U, 0x7FFFFFFFU}}) {
    const Problem too_large = problem(claiming(width, height));
    EXPECT_EQ(too_large.trouble, Trouble::limit) << too_large.message;
    EXPECT_NE(too_large.message.find("pixels"), std::string::npos) << too_large.message;
  }
}

long peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(Png, NoMemoryIsTakenForChunksThatClaimToBeHuge) {
  constexpr std::size_t after_head = 33;
  const long before = peak_kib();
  for (const char* kind : {"tEXt", "iCCP", "zTXt", "sPLT", "juNk"}) {
    std::string file = small_file();
    file.insert(after_head, std::string("\x60\0\0\0", 4) + kind + std::string(40, 'a'));
    EXPECT_NE(problem(file).message, "") << kind;
  }
  EXPECT_LT(peak_kib() - before, 256L << 10U);
}

TEST(Png, AFileTooShortForItsSizeIsRefusedAtOnce) {
  EXPECT_NE(problem(claiming(8192, 8192)).message.find("cut short"), std::string::npos);
  EXPECT_NE(problem(claiming(33, 22)).message, "");
  EXPECT_NE(problem(claiming(0, 21)).message, "");
}

/// `bytes` with up to six places behind the signature erased, doubled or overwritten.
std::string changed_at_random(std::string bytes, std::uint64_t seed) {
  const auto chance = [&](std::uint64_t key, std::size_t below) {
    return static_cast<std::size_t>(random_bits(seed, key) % below);
  };
  for (std::uint64_t change = 1; change <= 1 + chance(0, 6) && bytes.size() > 16; ++change) {
    const std::size_t at = 8 + chance(10 * change, bytes.size() - 8);
    const std::size_t kind = chance(10 * change + 1, 10);
    const std::size_t length = 1 + chance(10 * change + 2, 40);
    if (kind == 0) {
      bytes.erase(at, length);
    } else if (kind == 1) {
      bytes.insert(at, bytes.substr(8 + chance(10 * change + 3, bytes.size() - 8), length));
    } else {
      bytes[at] = static_cast<char>(chance(10 * change + 4, 256));
    }
  }
  return bytes;
}

TEST(Png, RandomChangesGiveAPictureOrAProblem) {
  MadePng palette{40, 40, PNG_COLOR_TYPE_PALETTE, 4, true};
  palette.palette = {{1, 2, 3}, {4, 5, 6}};
  palette.palette_alpha = {7};
  const std::string start[] = {small_file(), small_file(true), claiming(2000, 2000),
                               made_png(palette, [](int x, int y, int) { return pattern(x, y, 0, 1); })};
  int pictures = 0;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    std::string bytes = changed_at_random(start[seed % 4], seed);
    if (seed % 8 < 6) bytes = with_right_checksums(std::move(bytes));
    const Result<Image> image = read_png(bytes, "a.png");
    if (image) {
      ++pictures;
      ASSERT_EQ(image->rgba.size(), 4U * static_cast<std::size_t>(image->width * image->height)) << seed;
    } else {
      ASSERT_FALSE(image.problems().front().message.empty()) << seed;
    }
  }
  EXPECT_GT(pictures, 100) << "some changes leave a picture";
}

}  // namespace
}  // namespace burin::data
