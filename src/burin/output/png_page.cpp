#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include <burin/base/check.hpp>
#include <burin/output/deflate.hpp>
#include <burin/output/png_page.hpp>
#include <burin/output/row_deflater.hpp>

namespace {

/// Of compression. Measured on line pages: the levels below are hardly faster and their files larger.
constexpr int level = 6;

/// What stb_image_write calls in place of its own compressor; it frees what it gets.
unsigned char* deflate_for_stb(unsigned char* bytes, int size, int* deflated_size, int) {
  burin::output::Deflater deflate(level);
  const std::string_view packed = deflate({reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)});
  *deflated_size = static_cast<int>(packed.size());
  auto* const copy = static_cast<unsigned char*>(std::malloc(packed.size()));
  if (copy != nullptr) std::memcpy(copy, packed.data(), packed.size());
  return copy;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS deflate_for_stb
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace burin::output {

namespace {

std::string chunk_bytes(const PngChunk& chunk) {
  const std::string checked = chunk.type + chunk.data;
  return big_endian(static_cast<std::uint32_t>(chunk.data.size())) + checked + big_endian(crc32_of(checked));
}

std::string palette_bytes(const std::vector<Colour>& palette) {
  std::string bytes;
  for (const Colour colour : palette) {
    bytes += static_cast<char>(colour.red);
    bytes += static_cast<char>(colour.green);
    bytes += static_cast<char>(colour.blue);
  }
  return bytes;
}

/// All of the file before the pixels.
std::string file_head(const PngHead& head) {
  constexpr char bits = 8;
  std::string header = big_endian(head.width) + big_endian(head.height) + bits;
  header += static_cast<char>(head.pixels == PngPixels::rgb ? 2 : head.pixels == PngPixels::palette ? 3 : 0);
  header += std::string(3, '\0');  // deflate, filters of method 0, not interlaced
  std::string bytes = "\x89PNG\r\n\x1A\n" + chunk_bytes({"IHDR", header});
  for (const PngChunk& chunk : head.chunks) bytes += chunk_bytes(chunk);
  if (head.pixels == PngPixels::palette) bytes += chunk_bytes({"PLTE", palette_bytes(head.palette)});
  return bytes;
}

/// Nothing: the page is not blank enough for it.
std::optional<std::string> in_rows(const PngHead& head, const ReadRow& read_row) {
  std::vector<std::uint8_t> row(1 + head.bytes_per_row(), 0);  // no filter
  RowDeflater deflate(row.size());
  for (std::uint32_t j = 0; j < head.height; ++j) {
    read_row(j, row.data() + 1);
    if (!deflate.add(row.data())) return std::nullopt;
  }
  return file_head(head) + chunk_bytes({"IDAT", deflate.finish()}) + chunk_bytes({"IEND", {}});
}

/// Through stb, whose file gets our head. A palette page goes through it as a grey one, since the bytes are the same.
std::optional<std::string> at_once(const PngHead& head, const ReadRow& read_row) {
  std::vector<std::uint8_t> bytes(head.bytes_per_row() * head.height);
  for (std::uint32_t j = 0; j < head.height; ++j) read_row(j, bytes.data() + j * head.bytes_per_row());
  // Line art: no filter is both the fastest and the smallest. Set once: several pages may be written at a time.
  static const int filter = stbi_write_force_png_filter = 0;
  static_cast<void>(filter);
  int size = 0;
  unsigned char* const file =
      stbi_write_png_to_mem(bytes.data(), static_cast<int>(head.bytes_per_row()), static_cast<int>(head.width),
                            static_cast<int>(head.height), head.pixels == PngPixels::rgb ? 3 : 1, &size);
  if (file == nullptr) return std::nullopt;
  constexpr std::size_t head_bytes = 8 + 12 + 13;  // signature and IHDR
  std::string all = file_head(head);
  all.append(reinterpret_cast<const char*>(file) + head_bytes, static_cast<std::size_t>(size) - head_bytes);
  std::free(file);
  return all;
}

/// So much is compressed at a time. The less, the more repetitions of what came before are lost; half of it makes the
/// files of line pages 0.3 % larger.
constexpr std::size_t stripe_bytes = std::size_t{1} << 19U;

std::uint32_t rows_per_stripe(const PngHead& head) {
  return static_cast<std::uint32_t>(std::max<std::size_t>(1, stripe_bytes / (1 + head.bytes_per_row())));
}

/// Some rows of the page: their piece of the zlib stream in a chunk of its own.
struct Stripe {
  std::string chunk;
  std::size_t bytes = 0;
  std::uint32_t checksum = 1;
};

Stripe stripe(const PngHead& head, std::uint32_t top, const ReadRow& read_row) {
  const std::size_t row_bytes = 1 + head.bytes_per_row();
  const std::uint32_t rows = std::min(rows_per_stripe(head), head.height - top);
  std::string bytes(row_bytes * rows, '\0');  // no filter
  for (std::uint32_t j = 0; j < rows; ++j) {
    read_row(top + j, reinterpret_cast<std::uint8_t*>(bytes.data()) + j * row_bytes + 1);
  }
  Deflater deflate(level);
  std::string piece(top == 0 ? zlib_start : "");
  piece += deflate.piece(bytes);
  return {chunk_bytes({"IDAT", std::move(piece)}), bytes.size(), adler32_of(bytes)};
}

/// The stripes are the same whoever makes them.
std::string in_stripes(const PngHead& head, const ReadRow& read_row, const Executor& executor) {
  const std::uint32_t rows = rows_per_stripe(head);
  std::vector<Stripe> stripes((head.height + rows - 1) / rows);
  executor.run(stripes.size(),
               [&](std::size_t k) { stripes[k] = stripe(head, static_cast<std::uint32_t>(k) * rows, read_row); });
  std::string all = file_head(head);
  std::uint32_t checksum = adler32_of({});
  for (Stripe& each : stripes) {
    all += std::exchange(each.chunk, {});
    checksum = joint_adler32(checksum, each.checksum, each.bytes);
  }
  all += chunk_bytes({"IDAT", zlib_end(checksum)});
  return all += chunk_bytes({"IEND", {}});
}

}  // namespace

std::optional<std::string> png_page(const PngHead& head, const ReadRow& read_row, const Executor& executor) {
  BURIN_EXPECT(head.bytes_per_row() * head.height < std::size_t{1} << 31U);
  std::optional<std::string> file = in_rows(head, read_row);
  if (file) return file;
  return head.height <= rows_per_stripe(head) ? at_once(head, read_row) : in_stripes(head, read_row, executor);
}

std::optional<std::string> png_page(const PngHead& head, const std::vector<std::uint8_t>& bytes) {
  BURIN_EXPECT(bytes.size() == head.bytes_per_row() * head.height);
  return png_page(head, [&](std::uint32_t j, std::uint8_t* row) {
    std::memcpy(row, bytes.data() + j * head.bytes_per_row(), head.bytes_per_row());
  });
}

}  // namespace burin::output
