#include <algorithm>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/base/utf8.hpp>
#include <burin/curves/text/caption.hpp>
#include <burin/curves/text/glyph.hpp>

namespace burin::curves::lettering {

namespace {

std::string with_plain_line_ends(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '\r') {
      plain += text[at];
    } else if (text.substr(at, 2) != "\r\n") {
      plain += '\n';
    }
  }
  return plain;
}

/// What {name} stands for; nothing after reporting.
const std::string* placeholder(std::string_view name, const Where& where, params::ReadContext& context) {
  std::vector<std::string_view> known;
  for (const params::Placeholder& each : context.placeholders) {
    if (each.name == name && each.value.empty()) {
      context.report(where, fmt::format("'{{{}}}' stands for nothing: the preset does not say its {}", name, name));
      return nullptr;
    }
    if (each.name == name) return &each.value;
    known.push_back(each.name);
  }
  context.report(where, fmt::format("unknown placeholder '{{{}}}' ({{{{ and }}}} are braces){}", name,
                                    known.empty() ? "" : suggestion(name, known)));
  return nullptr;
}

/// The text with its placeholders put in; nothing after reporting.
std::optional<std::string> expanded(std::string_view text, const Where& where, params::ReadContext& context) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view two = text.substr(at, 2);
    if (two == "{{" || two == "}}") {
      result += text[at];
      at += 2;
    } else if (text[at] == '{') {
      const std::size_t end = text.find('}', at);
      if (end == std::string_view::npos) {
        context.report(where, "a '{' without its '}'; write {{ for a brace");
        return std::nullopt;
      }
      const std::string* value = placeholder(text.substr(at + 1, end - at - 1), where, context);
      if (value == nullptr) return std::nullopt;
      result += *value;
      at = end + 1;
    } else if (text[at] == '}') {
      context.report(where, "a '}' without its '{'; write }} for a brace");
      return std::nullopt;
    } else {
      result += text[at++];
    }
  }
  return result;
}

bool is_visible(std::string_view text) {
  return text.find_first_not_of(" \n") != std::string_view::npos;
}

}  // namespace

std::optional<std::string> undrawable(std::string_view text) {
  int line = 1;
  int column = 1;
  while (!text.empty()) {
    const auto [code, length] = first_utf8_character(text);
    if (length == 0) {
      return fmt::format("byte 0x{:02X} is not UTF-8, character {} of line {}",
                         static_cast<unsigned>(static_cast<unsigned char>(text.front())), column, line);
    }
    if (code == U'\n') {
      ++line;
      column = 1;
    } else if (!glyph_of(Font::sans, code)) {
      const std::string shown = code < U' ' || code == 0x7F ? "" : fmt::format("'{}' ", text.substr(0, length));
      return fmt::format(
          "no glyph for {}(U+{:04X}), character {} of line {}; there are the letters of ASCII and Latin-1, accented "
          "ones of Latin Extended-A and common marks",
          shown, static_cast<std::uint32_t>(code), column, line);
    } else {
      ++column;
    }
    text.remove_prefix(length);
  }
  return std::nullopt;
}

}  // namespace burin::curves::lettering

namespace burin::params {

using curves::lettering::Caption;

bool ValueType<Caption>::read(const Value& value, Caption& caption, ReadContext& context) {
  const std::string* written = value.text();
  if (written == nullptr) return report_kind(value, "a text", context);
  const std::optional<std::string> text = curves::lettering::expanded(*written, value.where, context);
  if (!text) return false;
  caption.text = curves::lettering::with_plain_line_ends(*text);
  if (const std::optional<std::string> trouble = curves::lettering::undrawable(caption.text)) {
    context.report(value.where, *trouble);
    return false;
  }
  if (!curves::lettering::is_visible(caption.text)) {
    context.report(value.where, "the text has no letter to draw");
    return false;
  }
  return true;
}

}  // namespace burin::params
