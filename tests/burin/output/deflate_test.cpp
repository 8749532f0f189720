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

TEST(Deflater, PiecesMakeAStream) {
  output::Deflater deflate(6);
  std::string bytes;
  std::string stream(output::zlib_start);
  std::uint32_t checksum = output::adler32_of({});
  std::uint32_t dice = 5;
  for (const std::size_t size : {1U, 0U, 7U, 100U, 30'000U, 300'000U, 70'000U, 31U, 32U, 33U}) {
    std::string some;
    while (some.size() < size) some += static_cast<char>((dice = dice * 1664525U + 1013904223U) >> 29U);
    stream += deflate.piece(some);
    checksum = output::joint_adler32(checksum, output::adler32_of(some), some.size());
    bytes += some;
    EXPECT_EQ(checksum, output::adler32_of(bytes)) << size;
    EXPECT_EQ(inflated(stream + output::zlib_end(checksum), bytes.size()), bytes) << size;
  }
}

TEST(Deflater, PiecesMayEndAtAnyBit) {
  // Of one byte more each: the ends of their blocks take all places in a byte.
  output::Deflater deflate(6);
  for (std::size_t size = 0; size < 400; ++size) {
    std::string some;
    for (std::size_t k = 0; k < size; ++k) some += static_cast<char>(k * k % 61);
    std::string stream(output::zlib_start);
    for (int k = 0; k < 2; ++k) stream += deflate.piece(some);
    EXPECT_EQ(inflated(stream + output::zlib_end(output::adler32_of(some + some)), 2 * size), some + some) << size;
  }
}

}  // namespace
}  // namespace burin
