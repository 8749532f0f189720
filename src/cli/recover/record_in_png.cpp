#include <cstdint>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <cli/recover/found_record.hpp>
#include <cli/recover/inflate.hpp>
#include <cli/recover/utf8_text.hpp>

namespace burin::cli {

namespace {

constexpr std::string_view keyword = "burin-origin";
constexpr std::size_t signature_bytes = 8;
constexpr std::uint64_t longest_chunk = 0x7FFFFFFF;  // PNG 1.2, section 3.2

std::uint32_t big_endian(std::string_view four) {
  std::uint32_t value = 0;
  for (const char c : four.substr(0, 4)) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

std::string utf8_of_latin1(std::string_view text) {
  std::string utf8;
  for (const char c : text) append_utf8(utf8, static_cast<unsigned char>(c));
  return utf8;
}

std::optional<std::string> unpacked(std::string_view text) {
  return inflated(text, longest_record_bytes);
}

/// What follows the first zero byte; nothing when there is none.
std::optional<std::string_view> behind_zero(std::string_view text) {
  const std::size_t zero = text.find('\0');
  if (zero == std::string_view::npos) return std::nullopt;
  return text.substr(zero + 1);
}

/// The text of a tEXt, zTXt or iTXt chunk behind its keyword and the zero; nothing when it is damaged.
std::optional<std::string> chunk_text(std::string_view type, std::string_view data) {
  if (type == "tEXt") return utf8_of_latin1(data);
  if (type == "zTXt") {
    if (data.empty() || data.front() != 0) return std::nullopt;  // the only method there is
    const std::optional<std::string> text = unpacked(data.substr(1));
    return text ? std::optional(utf8_of_latin1(*text)) : std::nullopt;
  }
  if (data.size() < 2) return std::nullopt;
  const bool packed = data[0] != 0;
  if (packed && data[1] != 0) return std::nullopt;
  const std::optional<std::string_view> behind_language = behind_zero(data.substr(2));
  const std::optional<std::string_view> text = behind_language ? behind_zero(*behind_language) : std::nullopt;
  if (!text) return std::nullopt;
  return packed ? unpacked(*text) : std::optional(std::string(*text));
}

}  // namespace

Result<std::string> record_in_png(const BytesAt& png, const std::string& shown) {
  const auto refuse = [&](std::string message) { return Problem{{shown}, std::move(message)}; };
  for (std::uint64_t at = signature_bytes; at < png.size;) {
    const std::string head = png.read(at, 8);
    if (head.size() < 8) break;
    const std::uint64_t length = big_endian(head);
    const std::string type = head.substr(4);
    if (length > longest_chunk) return refuse(fmt::format("is damaged: a chunk of the PNG claims {} bytes", length));
    if (type == "IEND") {
      return refuse(
          fmt::format("has no text chunk '{}': it was not drawn by burin, or a program that saved it again "
                      "dropped its texts",
                      keyword));
    }
    const bool is_text = type == "tEXt" || type == "zTXt" || type == "iTXt";
    if (is_text && png.read(at + 8, keyword.size() + 1) == std::string(keyword) + '\0') {
      if (length > longest_record_bytes) {
        return refuse(fmt::format("its text chunk '{}' has {} bytes; burin writes at most {} MiB", keyword, length,
                                  longest_record_bytes >> 20U));
      }
      const std::string body = png.read(at + 8, static_cast<std::size_t>(length));
      const std::string sum = png.read(at + 8 + length, 4);
      if (body.size() < length || sum.size() < 4) break;
      if (crc32_of(type + body) != big_endian(sum)) {
        return refuse(fmt::format("its text chunk '{}' is damaged: the checksum is wrong", keyword));
      }
      std::optional<std::string> text = chunk_text(type, std::string_view(body).substr(keyword.size() + 1));
      if (text) return *std::move(text);
      return refuse(fmt::format("its text chunk '{}' ({}) is damaged: it cannot be unpacked", keyword, type));
    }
    at += length + 12;
  }
  return refuse(fmt::format("ends too early: the PNG is cut off before its text chunk '{}' was found", keyword));
}

}  // namespace burin::cli
