#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include <burin/output/png_picture.hpp>

namespace burin::output {

/// Writes a PNG row by row through libpng, in constant memory. Few colours in a palette are packed into 1, 2 or 4 bits.
class PngRows {
 public:
  PngRows(const PngHead& head, WriteBytes write);
  ~PngRows();

  /// The next row from the top, PngHead::bytes_per_row() bytes.
  void add(const std::uint8_t* row);
  /// After the last row. False: the bytes could not be written, or there was no memory.
  bool finish();

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace burin::output
