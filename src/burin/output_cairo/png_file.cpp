#include <csetjmp>
#include <optional>

#include <png.h>

#include <burin/output_cairo/origin_text.hpp>
#include <burin/output_cairo/png_file.hpp>

namespace burin::output_cairo {

namespace {

/// `text` in Latin-1 when it has printable characters of Latin-1 and line feeds only, as a tEXt chunk asks.
std::optional<std::string> latin1(const std::string& text) {
  std::string narrow;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(text[i]);
    if (byte == '\n' || (byte >= 0x20 && byte < 0x7F)) {
      narrow += text[i];
    } else if ((byte == 0xC2 || byte == 0xC3) && i + 1 < text.size()) {
      const unsigned code = (byte & 3U) << 6U | (static_cast<std::uint8_t>(text[++i]) & 0x3FU);
      if (code < 0xA0) return std::nullopt;
      narrow += static_cast<char>(code);
    } else {
      return std::nullopt;
    }
  }
  return narrow;
}

/// A text with its bytes as its chunk has them.
struct TextChunk {
  std::string keyword;
  std::string bytes;
  int compression;
};

/// What png_set_text takes; the strings must stay.
png_text as_png_text(TextChunk& chunk) {
  png_text text{};
  text.compression = chunk.compression;
  text.key = chunk.keyword.data();
  text.text = chunk.bytes.data();
  if (chunk.compression == PNG_ITXT_COMPRESSION_NONE) {
    text.itxt_length = chunk.bytes.size();
  } else {
    text.text_length = chunk.bytes.size();
  }
  return text;
}

TextChunk text_chunk(const PngText& text) {
  std::string carried = carried_text(text.text);
  if (auto narrow = latin1(carried)) return {text.keyword, std::move(*narrow), PNG_TEXT_COMPRESSION_NONE};
  return {text.keyword, std::move(carried), PNG_ITXT_COMPRESSION_NONE};
}

/// Red, green and blue, or the grey they share, of one row of CAIRO_FORMAT_RGB24: a native 0xXXRRGGBB each.
void pack_row(const PngPicture& picture, std::size_t y, std::vector<png_byte>& packed) {
  const auto* pixel = reinterpret_cast<const std::uint32_t*>(picture.rows + y * picture.bytes_per_row);
  png_byte* byte = packed.data();
  for (std::uint32_t x = 0; x < picture.width; ++x, ++pixel) {
    if (!picture.grey) {
      *byte++ = static_cast<png_byte>(*pixel >> 16U & 0xFFU);
      *byte++ = static_cast<png_byte>(*pixel >> 8U & 0xFFU);
    }
    *byte++ = static_cast<png_byte>(*pixel & 0xFFU);
  }
}

// libpng leaves by longjmp: nothing with a destructor may live in a frame that it jumps over.
[[noreturn]] void fail(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void write_bytes(png_structp png, png_bytep bytes, png_size_t count) {
  auto* to = static_cast<ByteStream*>(png_get_io_ptr(png));
  if (!to->write({reinterpret_cast<const char*>(bytes), count})) png_error(png, "the stream failed");
}

void flush_bytes(png_structp) {}

bool write_chunks(png_structp png, png_infop info, const PngPicture& picture, std::vector<png_text>& texts,
                  std::vector<png_byte>& packed, ByteStream& to) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_write_fn(png, &to, write_bytes, flush_bytes);
  png_set_IHDR(png, info, picture.width, picture.height, 8, picture.grey ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_pHYs(png, info, picture.dots_per_metre, picture.dots_per_metre, PNG_RESOLUTION_METER);
  png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
  // Line art: no filter is both the fastest and the smallest.
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_compression_level(png, 6);
  png_set_compression_buffer_size(png, 65536);
  png_write_info(png, info);
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    pack_row(picture, y, packed);
    png_write_row(png, packed.data());
  }
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

bool write_png(const PngPicture& picture, ByteStream& to) {
  std::vector<TextChunk> chunks;
  for (const PngText& text : picture.texts) chunks.push_back(text_chunk(text));
  std::vector<png_text> texts;
  for (TextChunk& chunk : chunks) texts.push_back(as_png_text(chunk));
  std::vector<png_byte> packed(std::size_t{picture.width} * (picture.grey ? 1 : 3));

  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore_warning);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  const bool written = info != nullptr && write_chunks(png, info, picture, texts, packed, to);
  png_destroy_write_struct(&png, &info);
  return written;
}

}  // namespace burin::output_cairo
