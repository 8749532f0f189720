#include <array>

#include <gtest/gtest.h>

#include <burin/output/deflate.hpp>
#include <burin/output/png_page.hpp>

#include "decoded_png.hpp"
#include "support/random_paths.hpp"
#include "support/threads.hpp"

namespace burin::test {
namespace {

using output::PngHead;
using output::PngPixels;

/// Tasks from the last to the first.
class Backwards final : public Executor {
 public:
  void run(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    while (count > 0) task(--count);
  }
};

constexpr std::array<PngPixels, 3> all_pixels = {PngPixels::grey, PngPixels::rgb, PngPixels::palette};

PngHead head_of(PngPixels pixels, std::uint32_t width, std::uint32_t height) {
  PngHead head{.width = width, .height = height, .pixels = pixels};
  for (unsigned k = 0; pixels == PngPixels::palette && k < 256; ++k) {
    head.palette.push_back({static_cast<std::uint8_t>(k), static_cast<std::uint8_t>(255 - k), 7});
  }
  return head;
}

/// Short runs: too busy for rows on their own.
std::vector<std::uint8_t> busy_bytes(const PngHead& head) {
  Dice dice(8);
  std::vector<std::uint8_t> bytes;
  while (bytes.size() < head.bytes_per_row() * head.height) {
    bytes.insert(bytes.end(), 1 + dice.below(6), static_cast<std::uint8_t>(dice.below(40) * 6));
  }
  bytes.resize(head.bytes_per_row() * head.height);
  return bytes;
}

std::string page(const PngHead& head, const std::vector<std::uint8_t>& bytes, const Executor& executor) {
  const auto read_row = [&](std::uint32_t j, std::uint8_t* row) {
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(j * head.bytes_per_row()), head.bytes_per_row(), row);
  };
  return output::png_page(head, read_row, executor).value();
}

std::vector<std::uint8_t> rgb_of(const PngHead& head, const std::vector<std::uint8_t>& bytes) {
  if (head.pixels == PngPixels::rgb) return bytes;
  std::vector<std::uint8_t> rgb;
  for (const std::uint8_t byte : bytes) {
    const Colour colour = head.pixels == PngPixels::palette ? head.palette[byte] : Colour{byte, byte, byte};
    rgb.insert(rgb.end(), {colour.red, colour.green, colour.blue});
  }
  return rgb;
}

std::size_t count_of(const std::string& file, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = file.find(what); at != std::string::npos; at = file.find(what, at + 1)) ++count;
  return count;
}

TEST(PngPage, OfManyStripesHasTheSameBytesForEveryExecutor) {
  for (const PngPixels pixels : all_pixels) {
    const PngHead head = head_of(pixels, 1300, 1500);
    const std::vector<std::uint8_t> bytes = busy_bytes(head);
    const std::string file = page(head, bytes, SerialExecutor());
    EXPECT_GE(count_of(file, "IDAT"), 4U);
    EXPECT_TRUE(page(head, bytes, Threads()) == file);
    EXPECT_TRUE(page(head, bytes, Backwards()) == file);
    EXPECT_TRUE(output::png_page(head, bytes).value() == file);
    EXPECT_TRUE(decoded_png(file).rgb == rgb_of(head, bytes));
  }
}

TEST(PngPage, MayHaveBlankStripesAmongBusyOnes) {
  const PngHead head = head_of(PngPixels::grey, 2047, 1280);
  std::vector<std::uint8_t> bytes = busy_bytes(head);
  for (const std::size_t stripe : {0U, 2U, 4U}) {
    const auto top = bytes.begin() + static_cast<std::ptrdiff_t>(stripe * 256 * 2047);
    std::fill(top, top + 256 * 2047, std::uint8_t{255});
  }
  const std::string file = page(head, bytes, Threads());
  EXPECT_TRUE(decoded_png(file).rgb == rgb_of(head, bytes));
  EXPECT_LE(file.size(), page(head, busy_bytes(head), Threads()).size() * 2 / 5 + 5000);
}

TEST(PngPage, MayEndAnywhereInAStripe) {
  // 2048 bytes a row with the filter's make 256 rows a stripe.
  for (const std::uint32_t height : {255U, 256U, 257U, 511U, 512U, 513U}) {
    const PngHead head = head_of(PngPixels::grey, 2047, height);
    const std::vector<std::uint8_t> bytes = busy_bytes(head);
    const std::string file = page(head, bytes, SerialExecutor());
    EXPECT_EQ(count_of(file, "IDAT"), height <= 256 ? 1U : (height + 255U) / 256U + 1U) << "and the end of the stream";
    EXPECT_TRUE(decoded_png(file).rgb == rgb_of(head, bytes)) << height;
  }
}

TEST(PngPage, MayHaveRowsLongerThanAStripe) {
  const PngHead head = head_of(PngPixels::grey, 600'000, 3);
  const std::vector<std::uint8_t> bytes = busy_bytes(head);
  const std::string file = page(head, bytes, Threads());
  EXPECT_EQ(count_of(file, "IDAT"), 4U);
  EXPECT_TRUE(decoded_png(file).rgb == rgb_of(head, bytes));
}

TEST(PngPage, InStripesIsHardlyLargerThanAtOnce) {
  // Slanted lines: every row is the one above, a pixel on, but for some pixels; each stripe has to begin anew.
  const PngHead head = head_of(PngPixels::grey, 1000, 3000);
  Dice dice(9);
  std::vector<std::uint8_t> bytes(head.bytes_per_row() * head.height);
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    bytes[k] = k < 1000 || dice.below(50) == 0 ? static_cast<std::uint8_t>(dice.below(4) * 80) : bytes[k - 999];
  }
  std::string filtered;
  for (std::size_t j = 0; j < head.height; ++j) {
    const auto row = bytes.begin() + static_cast<std::ptrdiff_t>(j * head.bytes_per_row());
    filtered += '\0';
    filtered.append(row, row + head.width);
  }
  const std::string file = page(head, bytes, SerialExecutor());
  EXPECT_EQ(count_of(file, "IDAT"), 7U);
  EXPECT_LE(static_cast<double>(file.size()), 1.02 * static_cast<double>(output::Deflater(6)(filtered).size()));
}

}  // namespace
}  // namespace burin::test
