#include <array>
#include <string>
#include <zlib.h>

#include <gtest/gtest.h>

#include <burin/output/last_block.hpp>

#include "support/random_paths.hpp"

namespace burin::test {
namespace {

using output::LastBlock;

/// Text, runs and noise, in turns.
std::string mixed_bytes(std::size_t size) {
  Dice dice(77);
  std::string bytes;
  while (bytes.size() < size) {
    const std::size_t some = 200 + dice.below(3000);
    const auto kind = dice.below(3);
    for (std::size_t k = 0; k < some; ++k) {
      bytes += static_cast<char>(kind == 0 ? dice.below(256) : kind == 1 ? 'a' + dice.below(4) : 200);
    }
  }
  bytes.resize(size);
  return bytes;
}

/// A raw stream by zlib, which has every kind of block.
std::string deflated(std::string bytes, int level, int strategy) {
  z_stream state{};
  EXPECT_EQ(deflateInit2(&state, level, Z_DEFLATED, -15, 9, strategy), Z_OK);
  std::string stream(deflateBound(&state, bytes.size()) + 100, '\0');
  state.next_in = reinterpret_cast<Bytef*>(bytes.data());
  state.avail_in = static_cast<uInt>(bytes.size());
  state.next_out = reinterpret_cast<Bytef*>(stream.data());
  state.avail_out = static_cast<uInt>(stream.size());
  EXPECT_EQ(deflate(&state, Z_FINISH), Z_STREAM_END);
  stream.resize(state.total_out);
  deflateEnd(&state);
  return stream;
}

/// By zlib, which stops between blocks.
LastBlock last_by_zlib(std::string stream) {
  z_stream state{};
  EXPECT_EQ(inflateInit2(&state, -15), Z_OK);
  state.next_in = reinterpret_cast<Bytef*>(stream.data());
  state.avail_in = static_cast<uInt>(stream.size());
  std::array<Bytef, 4096> bytes;
  LastBlock last;
  for (int result = Z_OK; result == Z_OK;) {
    state.next_out = bytes.data();
    state.avail_out = bytes.size();
    result = inflate(&state, Z_BLOCK);
    const auto unused = static_cast<std::size_t>(state.data_type & 7);
    const bool between_blocks = (state.data_type & 128) != 0;
    const bool in_last = (state.data_type & 64) != 0;
    if (between_blocks && !in_last) last.begin = 8 * state.total_in - unused;
    if (between_blocks && in_last && last.end == 0) last.end = 8 * state.total_in - unused;
  }
  inflateEnd(&state);
  return last;
}

TEST(LastBlock, IsWhereZlibFindsIt) {
  for (const std::size_t size : {0U, 1U, 50U, 5000U, 300'000U}) {
    const std::string bytes = mixed_bytes(size);
    for (const int level : {0, 1, 6, 9}) {
      for (const int strategy : {Z_DEFAULT_STRATEGY, Z_FIXED, Z_HUFFMAN_ONLY, Z_RLE}) {
        const std::string stream = deflated(bytes, level, strategy);
        const LastBlock found = output::last_block(stream);
        const LastBlock expected = last_by_zlib(stream);
        EXPECT_EQ(found.begin, expected.begin) << size << ' ' << level << ' ' << strategy;
        EXPECT_EQ(found.end, expected.end) << size << ' ' << level << ' ' << strategy;
        EXPECT_EQ((found.end + 7) / 8, stream.size());
      }
    }
  }
}

}  // namespace
}  // namespace burin::test
