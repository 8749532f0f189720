#include <csetjmp>
#include <utility>
#include <vector>

#include <png.h>

#include <burin/output/png_rows.hpp>

namespace burin::output {

struct PngRows::Writer {
  PngHead head;
  WriteBytes write;
  std::vector<png_color> palette;
  png_structp png = nullptr;
  png_infop info = nullptr;
  bool good = false;

  void start();
  void row(const std::uint8_t* bytes);
  void end();
};

namespace {

// libpng leaves by longjmp: nothing with a destructor may live in a frame that it jumps over.
[[noreturn]] void fail(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void write_bytes(png_structp png, png_bytep bytes, png_size_t count) {
  const auto* write = static_cast<const WriteBytes*>(png_get_io_ptr(png));
  if (!(*write)({reinterpret_cast<const char*>(bytes), count})) png_error(png, "the bytes could not be written");
}

void flush_bytes(png_structp) {}

int bits_of(const PngHead& head) {
  if (head.pixels != PngPixels::palette || head.palette.size() > 16) return 8;
  if (head.palette.size() > 4) return 4;
  return head.palette.size() > 2 ? 2 : 1;
}

int colour_type(PngPixels pixels) {
  switch (pixels) {
    case PngPixels::grey:
      return PNG_COLOR_TYPE_GRAY;
    case PngPixels::rgb:
      return PNG_COLOR_TYPE_RGB;
    case PngPixels::palette:
      return PNG_COLOR_TYPE_PALETTE;
  }
  return PNG_COLOR_TYPE_RGB;
}

}  // namespace

void PngRows::Writer::start() {
  if (setjmp(png_jmpbuf(png)) != 0) {
    good = false;
    return;
  }
  png_set_write_fn(png, &write, write_bytes, flush_bytes);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_set_IHDR(png, info, head.width, head.height, bits_of(head), colour_type(head.pixels), PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  // Line art: no filter is both the fastest and the smallest.
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_compression_level(png, 6);
  png_set_compression_buffer_size(png, 65536);
  png_write_info_before_PLTE(png, info);
  for (const PngChunk& chunk : head.chunks) {
    png_write_chunk(png, reinterpret_cast<png_const_bytep>(chunk.type.data()),
                    reinterpret_cast<png_const_bytep>(chunk.data.data()), chunk.data.size());
  }
  png_write_info(png, info);
  png_set_packing(png);
}

void PngRows::Writer::row(const std::uint8_t* bytes) {
  if (setjmp(png_jmpbuf(png)) != 0) {
    good = false;
    return;
  }
  png_write_row(png, bytes);
}

void PngRows::Writer::end() {
  if (setjmp(png_jmpbuf(png)) != 0) {
    good = false;
    return;
  }
  png_write_end(png, nullptr);
}

PngRows::PngRows(const PngHead& head, WriteBytes write) : writer_(new Writer) {
  writer_->head = head;
  writer_->write = std::move(write);
  for (const Colour colour : head.palette) writer_->palette.push_back({colour.red, colour.green, colour.blue});
  writer_->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore_warning);
  if (writer_->png != nullptr) writer_->info = png_create_info_struct(writer_->png);
  writer_->good = writer_->info != nullptr;
  if (writer_->good) writer_->start();
}

PngRows::~PngRows() {
  png_destroy_write_struct(&writer_->png, &writer_->info);
}

void PngRows::add(const std::uint8_t* row) {
  if (writer_->good) writer_->row(row);
}

bool PngRows::finish() {
  if (writer_->good) writer_->end();
  return writer_->good;
}

}  // namespace burin::output
