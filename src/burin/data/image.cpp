#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <vector>

#include <fmt/format.h>
#include <png.h>

#include <burin/data/image.hpp>

namespace burin::data {

namespace {

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// No deflate stream unpacks to more than this many times its size.
constexpr std::uint64_t most_inflation = 1032;

/// libpng leaves by longjmp: nothing with a destructor may live in a frame that it jumps over. So each call of it that
/// may fail stands in a member function without any; false: it failed, and `complaint` says why.
struct PngReader {
  explicit PngReader(std::string_view all) : bytes(all) {}
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

  bool start();
  bool read_head();
  bool read_pixels(std::uint8_t** rows);

  std::string_view bytes;  ///< those not yet read
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  bool ended_early = false;
  std::array<char, 128> complaint{};
};

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  auto* const reader = static_cast<PngReader*>(png_get_error_ptr(png));
  std::strncpy(reader->complaint.data(), message, reader->complaint.size() - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void hand_over(png_structp png, png_bytep to, png_size_t count) {
  auto* const reader = static_cast<PngReader*>(png_get_io_ptr(png));
  if (reader->bytes.size() < count) {
    reader->ended_early = true;
    png_error(png, "it ends early");
  }
  std::memcpy(to, reader->bytes.data(), count);
  reader->bytes.remove_prefix(count);
}

bool PngReader::start() {
  png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore_warning);
  if (png != nullptr) info = png_create_info_struct(png);
  return info != nullptr;
}

bool PngReader::read_head() {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_read_fn(png, this, hand_over);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  // Only what pixels are made of is read: for a text libpng would take as much memory as its chunk claims to have.
  constexpr int every_other_chunk = -1;
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, every_other_chunk);
  png_read_info(png, info);
  width = png_get_image_width(png, info);
  height = png_get_image_height(png, info);
  return true;
}

bool PngReader::read_pixels(std::uint8_t** rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_scale_16(png);
  png_set_expand(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

Problem damage(const PngReader& reader, const std::string& file) {
  if (reader.ended_early) return {{file}, "is cut short: the PNG goes on where the file ends; copy it again"};
  return {{file}, fmt::format("is a damaged PNG, libpng says: {}", reader.complaint.data())};
}

}  // namespace

Result<Image> read_png(std::string_view bytes, const std::string& file) {
  if (!bytes.starts_with(png_signature)) return Problem{{file}, "is no PNG: it does not begin as one"};
  PngReader reader(bytes);
  if (!reader.start()) return Problem{{file}, "no memory is left to read it", Trouble::limit};
  if (!reader.read_head()) return damage(reader, file);
  if (std::uint64_t{reader.width} * reader.height > max_image_pixels) {
    return Problem{
        {file},
        fmt::format("has {} x {} pixels; at most {} are read in all", reader.width, reader.height, max_image_pixels),
        Trouble::limit};
  }
  const std::uint64_t stored_bytes = std::uint64_t{png_get_rowbytes(reader.png, reader.info)} * reader.height;
  if (stored_bytes / most_inflation > bytes.size()) {
    reader.ended_early = true;
    return damage(reader, file);
  }

  Image image{static_cast<int>(reader.width), static_cast<int>(reader.height), {}};
  const std::size_t row_bytes = std::size_t{4} * reader.width;
  image.rgba.resize(row_bytes * reader.height);
  std::vector<std::uint8_t*> rows(reader.height);
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = &image.rgba[y * row_bytes];
  if (!reader.read_pixels(rows.data())) return damage(reader, file);
  return image;
}

}  // namespace burin::data
