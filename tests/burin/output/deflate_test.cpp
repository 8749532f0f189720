#include <string>
#include <zlib.h>

#include <gtest/gtest.h>

#include <burin/output/deflate.hpp>

namespace burin {
namespace {

/// What zlib, which is not what wrote it, unpacks.
std::string inflated(std::string_view stream, std::size_t size) {
  std::string bytes(size + 1, '?');
  uLongf length = bytes.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length, reinterpret_cast<const Bytef*>(stream.data()),
                       stream.size()),
            Z_OK);
  bytes.resize(length);
  return bytes;
}

TEST(Deflater, ZlibReadsBackEveryBlock) {
  std::string noise;
  for (std::uint32_t bits = 1; noise.size() < 100'000; bits = bits * 1664525U + 1013904223U) {
    noise += static_cast<char>(bits >> 24U);
  }
  const std::string blank(1'000'000, ' ');
  for (const int level : {1, 6, 12}) {
    output::Deflater deflate(level);
    for (const std::string& block : {std::string("ab"), noise, std::string(), blank, noise}) {
      EXPECT_EQ(inflated(deflate(block), block.size()), block) << level;
    }
    EXPECT_LT(deflate(blank).size(), 2000U);
  }
}

}  // namespace
}  // namespace burin
