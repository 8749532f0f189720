#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <burin/output/prefix_code.hpp>

namespace burin::output {

/// Compresses the rows of a picture of lines into a zlib stream (RFC 1950), or a piece of one: every byte is the one to
/// its left again, or the one above, or stands for itself. On mostly blank pages that is as small as a search for all
/// repetitions and several times faster; on others it gives up. One dynamic block, in memory of 2 bytes a token.
class RowDeflater {
 public:
  /// All rows have `row_bytes` bytes, the byte for PNG's filter included.
  explicit RowDeflater(std::size_t row_bytes);

  /// Adds the next row. False: there is too much that does not repeat; nothing more can be added.
  bool add(const std::uint8_t* row);

  /// How many bytes and matches stand for the rows so far.
  std::size_t tokens() const { return tokens_.size(); }

  /// The stream of all rows.
  std::string finish();

  /// All rows as a piece of a stream, as Deflater::piece() makes them.
  std::string piece();

 private:
  /// How many bytes from `at` on are those above; 0 if they are hardly more than the `other` that repeat otherwise.
  std::size_t above(const std::uint8_t* row, std::size_t at, std::size_t other) const;
  void add_match(std::size_t length, bool from_above);
  void write_block(BitWriter& bits, bool is_last) const;

  std::size_t row_bytes_;
  std::size_t bytes_ = 0;
  std::uint32_t checksum_;
  std::vector<std::uint8_t> last_row_;
  std::vector<std::uint16_t> tokens_;  ///< a byte; or the length of a match less 3, with flags
};

}  // namespace burin::output
