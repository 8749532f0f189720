#include <cstdlib>
#include <cstring>
#include <string_view>

#include <burin/base/check.hpp>
#include <burin/output/deflate.hpp>
#include <burin/output/png_page.hpp>

namespace {

/// What stb_image_write calls in place of its own compressor; it frees what it gets.
unsigned char* deflate_for_stb(unsigned char* bytes, int size, int* deflated_size, int) {
  // Measured on line pages: the levels below are hardly faster and their files larger.
  burin::output::Deflater deflate(6);
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

constexpr std::size_t signature_bytes = 8;
constexpr std::size_t length_bytes = 4;
constexpr std::size_t frame_bytes = 12;  ///< length, type and checksum of a chunk
constexpr std::size_t header_bytes = 13;
constexpr std::size_t colour_type_at = 9;  ///< in IHDR

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

/// stb's file with our chunks between its header and its pixels. A palette page goes through stb as a grey one, since
/// the bytes are the same; here it gets its own colour type and the palette.
std::string with_our_chunks(std::string_view file, const PngHead& head) {
  const std::size_t header_end = signature_bytes + frame_bytes + header_bytes;
  PngChunk header{"IHDR", std::string(file.substr(signature_bytes + length_bytes + 4, header_bytes))};
  constexpr char palette_type = 3;
  const bool has_palette = head.pixels == PngPixels::palette;
  if (has_palette) header.data[colour_type_at] = palette_type;
  std::string all(file.substr(0, signature_bytes));
  all += chunk_bytes(header);
  for (const PngChunk& chunk : head.chunks) all += chunk_bytes(chunk);
  if (has_palette) all += chunk_bytes({"PLTE", palette_bytes(head.palette)});
  all += file.substr(header_end);
  return all;
}

}  // namespace

std::optional<std::string> png_page(const PngHead& head, const std::vector<std::uint8_t>& bytes) {
  BURIN_EXPECT(bytes.size() == head.bytes_per_row() * head.height && bytes.size() < std::size_t{1} << 31U);
  // Line art: no filter is both the fastest and the smallest. Set once: several pages may be written at a time.
  static const int filter = stbi_write_force_png_filter = 0;
  static_cast<void>(filter);
  int size = 0;
  unsigned char* const file =
      stbi_write_png_to_mem(bytes.data(), static_cast<int>(head.bytes_per_row()), static_cast<int>(head.width),
                            static_cast<int>(head.height), head.pixels == PngPixels::rgb ? 3 : 1, &size);
  if (file == nullptr) return std::nullopt;
  std::string all = with_our_chunks({reinterpret_cast<const char*>(file), static_cast<std::size_t>(size)}, head);
  std::free(file);
  return all;
}

}  // namespace burin::output
