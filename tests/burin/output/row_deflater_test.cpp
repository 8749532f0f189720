#include <functional>
#include <string>
#include <vector>
#include <zlib.h>

#include <gtest/gtest.h>

#include <burin/output/deflate.hpp>
#include <burin/output/prefix_code.hpp>
#include <burin/output/row_deflater.hpp>

#include "support/random_paths.hpp"

namespace burin::test {
namespace {

using output::PrefixCode;
using output::RowDeflater;

/// The stream of rows of so many bytes, which byte(row, column) gives; and what zlib, which did not write it, unpacks.
struct Packed {
  std::string bytes;
  std::string stream;
  std::string unpacked;
};

Packed packed(std::size_t rows, std::size_t columns, const std::function<int(std::size_t, std::size_t)>& byte) {
  Packed all;
  RowDeflater deflate(columns);
  for (std::size_t row = 0; row < rows; ++row) {
    std::string bytes;
    for (std::size_t column = 0; column < columns; ++column) bytes += static_cast<char>(byte(row, column));
    deflate.add(reinterpret_cast<const std::uint8_t*>(bytes.data()));
    all.bytes += bytes;
  }
  all.stream = deflate.finish();
  all.unpacked.assign(all.bytes.size() + 1, '?');
  uLongf length = all.unpacked.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(all.unpacked.data()), &length,
                       reinterpret_cast<const Bytef*>(all.stream.data()), all.stream.size()),
            Z_OK);
  all.unpacked.resize(length);
  return all;
}

TEST(RowDeflater, ZlibReadsBackRowsOfEveryLength) {
  Dice dice(31);
  for (const std::size_t columns : {1U, 2U, 3U, 4U, 9U, 258U, 259U, 263U, 300U, 2001U, 40000U}) {
    const Packed blank = packed(20, columns, [](std::size_t, std::size_t column) { return column == 0 ? 0 : 255; });
    EXPECT_TRUE(blank.unpacked == blank.bytes) << columns;
    const Packed noise =
        packed(3, columns, [&](std::size_t, std::size_t) { return static_cast<int>(dice.below(256)); });
    EXPECT_TRUE(noise.unpacked == noise.bytes) << columns;
    const Packed runs = packed(9, columns, [&](std::size_t row, std::size_t column) {
      return static_cast<int>(column / (row % 3 * 7 + 3) % 5 * 50);
    });
    EXPECT_TRUE(runs.unpacked == runs.bytes) << columns;
  }
}

TEST(RowDeflater, TakesFewBytesForBlankRowsAndForUprightLines) {
  const Packed blank = packed(2000, 2001, [](std::size_t, std::size_t column) { return column == 0 ? 0 : 255; });
  EXPECT_LE(blank.stream.size(), 2000U * 5);
  const Packed lines = packed(2000, 2001, [](std::size_t, std::size_t column) { return column % 50 < 3 ? 90 : 255; });
  EXPECT_TRUE(lines.unpacked == lines.bytes);
  EXPECT_LE(lines.stream.size(), 2000U * 15);
}

TEST(RowDeflater, PiecesMakeAStream) {
  std::string bytes;
  std::string stream(output::zlib_start);
  for (std::size_t columns = 1; columns < 300; columns += 13) {
    RowDeflater deflate(columns);
    for (std::size_t row = 0; row < 4; ++row) {
      std::string some;
      for (std::size_t k = 0; k < columns; ++k) some += static_cast<char>(k / (columns / 5 + 1) * row);
      deflate.add(reinterpret_cast<const std::uint8_t*>(some.data()));
      bytes += some;
    }
    stream += deflate.piece();
    std::string unpacked(bytes.size() + 1, '?');
    uLongf length = unpacked.size();
    const std::string whole = stream + output::zlib_end(output::adler32_of(bytes));
    EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(unpacked.data()), &length,
                         reinterpret_cast<const Bytef*>(whole.data()), whole.size()),
              Z_OK);
    unpacked.resize(length);
    EXPECT_TRUE(unpacked == bytes) << columns;
  }
}

TEST(RowDeflater, GivesUpOnNoise) {
  Dice dice(32);
  RowDeflater deflate(1000);
  std::vector<std::uint8_t> row(1000);
  int rows = 0;
  do {
    for (std::uint8_t& byte : row) byte = static_cast<std::uint8_t>(dice.below(256));
    ++rows;
  } while (deflate.add(row.data()));
  EXPECT_LE(rows, 30);
}

TEST(PrefixCode, IsCompleteAndAsLongAsAllowed) {
  // Fibonacci's numbers make the deepest tree.
  std::vector<std::uint32_t> deep = {1, 1};
  while (deep.size() < 40) deep.push_back(deep[deep.size() - 1] + deep[deep.size() - 2]);
  for (const unsigned most_bits : {7U, 15U}) {
    for (const std::vector<std::uint32_t>& counts : {deep, std::vector<std::uint32_t>(100, 3), {0, 0, 5, 0}, {0, 0}}) {
      const PrefixCode code(counts, most_bits);
      double share = 0.0;
      for (const std::uint8_t length : code.lengths()) {
        EXPECT_LE(length, most_bits);
        if (length > 0) share += 1.0 / static_cast<double>(1U << length);
      }
      EXPECT_EQ(share, 1.0);
    }
  }
}

TEST(PrefixCode, IsShortWhereCountsAreHigh) {
  const PrefixCode code({8, 4, 2, 1, 1}, 15);
  EXPECT_EQ(code.lengths(), (std::vector<std::uint8_t>{1, 2, 3, 4, 4}));
}

}  // namespace
}  // namespace burin::test
