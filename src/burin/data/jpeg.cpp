#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <jerror.h>
#include <jpeglib.h>
#include <optional>
#include <utility>
#include <vector>

#include <burin/data/jpeg.hpp>

namespace burin::data {

namespace {

/// libjpeg leaves by a jump when it gives up, so nothing with a destructor may live between setjmp and there.
struct Failure {
  jpeg_error_mgr manager;
  std::jmp_buf leave;
  char message[JMSG_LENGTH_MAX];
};

[[noreturn]] void give_up(j_common_ptr info) {
  auto* failure = reinterpret_cast<Failure*>(info->err);
  failure->manager.format_message(info, failure->message);
  std::longjmp(failure->leave, 1);
}

/// A warning is a file that is damaged or ends too early: no less wrong for a drawing that must be the same anywhere.
/// Cameras do leave bytes between segments, which harm nothing.
void take_no_warning(j_common_ptr info, int level) {
  if (level < 0 && info->err->msg_code != JWRN_EXTRANEOUS_DATA) give_up(info);
}

enum class Outcome : std::uint8_t { read, damaged, too_large, other_colours };

/// A decoder that cleans up after itself. Grey comes as one byte a pixel, colours as three.
struct Decoder {
  jpeg_decompress_struct info{};
  Failure failure{};
  std::vector<std::uint8_t> row;

  Decoder() = default;
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() { jpeg_destroy_decompress(&info); }

  Outcome begin(std::string_view bytes);
  Outcome read_rows(Image& image);
};

Outcome Decoder::begin(std::string_view bytes) {
  info.err = jpeg_std_error(&failure.manager);
  failure.manager.error_exit = give_up;
  failure.manager.emit_message = take_no_warning;
  if (setjmp(failure.leave) != 0) return Outcome::damaged;
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_save_markers(&info, JPEG_APP0 + 1, 0xFFFF);
  static_cast<void>(jpeg_read_header(&info, TRUE));
  if (std::uint64_t{info.image_width} * info.image_height > max_image_pixels) return Outcome::too_large;
  if (info.num_components != 1 && info.num_components != 3) return Outcome::other_colours;
  info.out_color_space = info.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
  info.dct_method = JDCT_ISLOW;  // the one that is exact and the same everywhere
  static_cast<void>(jpeg_start_decompress(&info));
  return Outcome::read;
}

/// Pre: `row` and `image` have room.
Outcome Decoder::read_rows(Image& image) {
  if (setjmp(failure.leave) != 0) return Outcome::damaged;
  const auto samples = static_cast<std::size_t>(info.output_components);
  std::uint8_t* to = image.rgba.data();
  while (info.output_scanline < info.output_height) {
    JSAMPROW rows[1] = {row.data()};
    static_cast<void>(jpeg_read_scanlines(&info, rows, 1));
    for (std::size_t x = 0; x < info.output_width; ++x) {
      const std::uint8_t* from = row.data() + x * samples;
      *to++ = from[0];
      *to++ = samples == 1 ? from[0] : from[1];
      *to++ = samples == 1 ? from[0] : from[2];
      *to++ = 255;
    }
  }
  static_cast<void>(jpeg_finish_decompress(&info));
  return Outcome::read;
}

/// Bytes of EXIF in the order that its header tells.
struct Exif {
  std::string_view bytes;
  bool big_endian = false;

  std::optional<std::uint32_t> number(std::size_t at, std::size_t size) const {
    if (at > bytes.size() || bytes.size() - at < size) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value = value << 8U | static_cast<std::uint8_t>(bytes[at + (big_endian ? i : size - 1 - i)]);
    }
    return value;
  }
};

/// The orientation, 1 to 8, that an APP1 segment tells; 1 when it does not. Source: Exif 2.3, 4.5 and 4.6.4.
int orientation_of(std::string_view segment) {
  constexpr std::string_view mark("Exif\0\0", 6);
  constexpr std::uint32_t orientation_tag = 0x0112;
  if (segment.substr(0, mark.size()) != mark) return 1;
  Exif exif{segment.substr(mark.size())};
  exif.big_endian = exif.bytes.substr(0, 2) == "MM";
  const std::optional<std::uint32_t> directory = exif.number(4, 4);
  const std::optional<std::uint32_t> count = directory ? exif.number(*directory, 2) : std::nullopt;
  for (std::size_t i = 0; i < count.value_or(0); ++i) {
    const std::size_t entry = std::size_t{*directory} + 2 + 12 * i;
    if (exif.number(entry, 2) != orientation_tag) continue;
    const std::uint32_t value = exif.number(entry + 8, 2).value_or(1);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

/// The picture turned upright. Orientations 5 to 8 change width and height.
Image upright(Image image, int orientation) {
  if (orientation == 1) return image;
  const bool swaps = orientation >= 5;
  const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Image turned{swaps ? image.height : image.width, swaps ? image.width : image.height, {}};
  turned.rgba.resize(image.rgba.size());
  std::uint8_t* to = turned.rgba.data();
  for (int y = 0; y < turned.height; ++y) {
    for (int x = 0; x < turned.width; ++x, to += 4) {
      const int column = swaps ? y : x;
      const int line = swaps ? x : y;
      std::memcpy(
          to, image.pixel(from_right ? image.width - 1 - column : column, from_bottom ? image.height - 1 - line : line),
          4);
    }
  }
  return turned;
}

Problem problem(const std::string& file, Outcome outcome, const Decoder& decoder) {
  if (outcome == Outcome::too_large) {
    return {{file}, "has more than the 67108864 pixels that a picture may have", Trouble::limit};
  }
  if (outcome == Outcome::other_colours) {
    return {{file}, "is a JPEG of " + std::to_string(decoder.info.num_components) + " inks; save it in RGB or grey"};
  }
  return {{file}, std::string("is no sound JPEG: ") + decoder.failure.message};
}

}  // namespace

Result<Image> read_jpeg(std::string_view bytes, const std::string& file) {
  if (bytes.substr(0, 2) != "\xFF\xD8") return Problem{{file}, "is no JPEG: its first bytes are not those of one"};
  Decoder decoder;
  if (const Outcome begun = decoder.begin(bytes); begun != Outcome::read) return problem(file, begun, decoder);
  Image image{static_cast<int>(decoder.info.output_width), static_cast<int>(decoder.info.output_height), {}};
  decoder.row.resize(std::size_t{decoder.info.output_width} * static_cast<std::size_t>(decoder.info.output_components));
  image.rgba.resize(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  int orientation = 1;
  for (const jpeg_marker_struct* marker = decoder.info.marker_list; marker != nullptr; marker = marker->next) {
    const std::string_view segment(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (orientation == 1) orientation = orientation_of(segment);
  }
  if (const Outcome read = decoder.read_rows(image); read != Outcome::read) return problem(file, read, decoder);
  return upright(std::move(image), orientation);
}

}  // namespace burin::data
