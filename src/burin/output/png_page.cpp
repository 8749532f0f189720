#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include <burin/base/check.hpp>
#include <burin/output/deflate.hpp>
#include <burin/output/png_page.hpp>
#include <burin/output/png_stripes.hpp>
#include <burin/output/row_deflater.hpp>

namespace {

/// What stb_image_write calls in place of its own compressor; it frees what it gets.
unsigned char* deflate_for_stb(unsigned char* bytes, int size, int* deflated_size, int) {
  burin::output::Deflater deflate(burin::output::png_level);
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

/// In rows, or if the page is not blank enough for it, in stripes.
std::string in_rows_or_stripes(const PngHead& head, const ReadRow& read_row, const Executor& executor) {
  std::string file;
  PngStripes stripes(head, [&](std::string_view some) {
    file += some;
    return true;
  });
  std::optional<std::string> rows;
  const bool is_in_stripes = stripes.add(head.height, read_row, executor, [&] {
    rows = in_rows(head, read_row);
    return rows.has_value();
  });
  if (!is_in_stripes) return std::move(*rows);
  stripes.finish();
  return file;
}

}  // namespace

std::optional<std::string> png_page(const PngHead& head, const ReadRow& read_row, const Executor& executor) {
  BURIN_EXPECT(head.bytes_per_row() * head.height < std::size_t{1} << 31U);
  if (head.height > PngStripes::rows_per_stripe(head)) return in_rows_or_stripes(head, read_row, executor);
  std::optional<std::string> file = in_rows(head, read_row);
  return file ? file : at_once(head, read_row);
}

std::optional<std::string> png_page(const PngHead& head, const std::vector<std::uint8_t>& bytes) {
  BURIN_EXPECT(bytes.size() == head.bytes_per_row() * head.height);
  return png_page(head, [&](std::uint32_t j, std::uint8_t* row) {
    std::memcpy(row, bytes.data() + j * head.bytes_per_row(), head.bytes_per_row());
  });
}

}  // namespace burin::output
