#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <cli/recover/found_record.hpp>
#include <cli/recover/xml_scanner.hpp>

namespace burin::cli {

namespace {

constexpr std::string_view svg_space = "http://www.w3.org/2000/svg";
constexpr std::string_view origin_space = "urn:x-burin:origin";
constexpr std::string_view looked_for = "<origin xmlns=\"urn:x-burin:origin\">";

/// The inverse of xml_exact_text once XML's own escapes are resolved; nothing for an escape that it does not write.
std::optional<std::string> exact_text(std::string_view escaped) {
  std::string text;
  for (std::size_t at = 0; at < escaped.size(); ++at) {
    if (escaped[at] != '\\') {
      text += escaped[at];
    } else if (escaped.substr(at + 1, 1) == "\\") {
      text += escaped[++at];
    } else {
      const std::string_view digits = escaped.substr(at + 1, 3);
      unsigned char byte = 0;
      const char* end = digits.data() + digits.size();
      if (digits.size() != 3 || digits[0] != 'x') return std::nullopt;
      const auto [stopped, error] = std::from_chars(digits.data() + 1, end, byte, 16);
      if (error != std::errc() || stopped != end) return std::nullopt;
      text += static_cast<char>(byte);
      at += 3;
    }
  }
  return text;
}

}  // namespace

Result<std::string> record_in_svg(const BytesAt& svg, const std::string& shown) {
  const auto refuse = [&](std::string message) { return Problem{{shown}, std::move(message)}; };
  XmlScanner scanner(svg);
  bool is_root = true;
  for (;;) {
    const XmlScanner::Tag tag = scanner.next_tag();
    if (is_root && tag.kind == XmlScanner::Kind::begin && (tag.name != "svg" || tag.space != svg_space)) {
      return refuse(fmt::format(
          "is XML, but no SVG: its root is <{}>; burin redraws SVG, PDF and PNG files that it drew", tag.name));
    }
    if (tag.kind == XmlScanner::Kind::broken) {
      return refuse(fmt::format("is cut off or no well-formed XML; {} was looked for in it", looked_for));
    }
    if (tag.kind == XmlScanner::Kind::finished) {
      return refuse(
          fmt::format("has no {} in its metadata: it was not drawn by burin, or a program that saved it again "
                      "dropped its metadata",
                      looked_for));
    }
    is_root = is_root && tag.kind != XmlScanner::Kind::begin;
    if (tag.kind != XmlScanner::Kind::begin || tag.name != "origin" || tag.space != origin_space) continue;
    const std::optional<std::string> content =
        tag.empty ? std::nullopt : scanner.text_content(2 * longest_record_bytes);
    const std::optional<std::string> text = content ? exact_text(*content) : std::nullopt;
    if (text && text->size() <= longest_record_bytes) return *text;
    return refuse(
        fmt::format("its {} is damaged: it must hold a text of at most {} MiB with burin's escapes and "
                    "nothing else",
                    looked_for, longest_record_bytes >> 20U));
  }
}

}  // namespace burin::cli
