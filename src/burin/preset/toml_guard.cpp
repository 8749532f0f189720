#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/preset/toml.hpp>
#include <burin/preset/toml_guard.hpp>

namespace burin::preset {

namespace {

constexpr int most_dots = 64;
constexpr int deepest_nesting = 64;

Where place_of(std::string_view text, const std::string& file, std::size_t offset) {
  Where where{file, 1, 1};
  for (std::size_t at = 0; at < offset; ++at) {
    if (text[at] == '\n') {
      ++where.line;
      where.column = 1;
    } else {
      ++where.column;
    }
  }
  return where;
}

/// Bytes of the UTF-8 character at `at`; 0 when there is none: overlong forms, surrogates, cut or lost bytes.
std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U; };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  if (first >= 0xC2U && first <= 0xDFU) return continues(1) ? 2 : 0;
  if (first >= 0xE0U && first <= 0xEFU) {
    const unsigned low = first == 0xE0U ? 0xA0U : 0x80U;
    const unsigned high = first == 0xEDU ? 0x9FU : 0xBFU;
    return byte(1) >= low && byte(1) <= high && continues(2) ? 3 : 0;
  }
  if (first >= 0xF0U && first <= 0xF4U) {
    const unsigned low = first == 0xF0U ? 0x90U : 0x80U;
    const unsigned high = first == 0xF4U ? 0x8FU : 0xBFU;
    return byte(1) >= low && byte(1) <= high && continues(2) && continues(3) ? 4 : 0;
  }
  return 0;
}

std::optional<Problem> refuse_bytes(std::string_view text, const std::string& file) {
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const std::size_t length = character_length(text, at);
    if (length == 0) {
      return Problem{place_of(text, file, at),
                     fmt::format("byte 0x{:02X} is not UTF-8; save the preset as UTF-8", byte)};
    }
    const bool control = (byte < 0x20U && byte != '\t' && byte != '\n' && byte != '\r') || byte == 0x7FU;
    if (control) {
      return Problem{place_of(text, file, at),
                     fmt::format("control character 0x{:02X} in the text; remove it (is this a preset?)", byte)};
    }
    at += length;
  }
  return std::nullopt;
}

/// The end of the string or comment that begins at `at`, or `at` when none does. What a syntax error makes ambiguous
/// does not matter: toml++ stops at the error.
std::size_t skip_quiet(std::string_view text, std::size_t at) {
  const char opener = text[at];
  if (opener == '#') return std::min(text.find('\n', at), text.size());
  if (opener != '"' && opener != '\'') return at;
  const std::string_view triple = opener == '"' ? "\"\"\"" : "'''";
  const bool many_lines = text.substr(at, 3) == triple;
  for (std::size_t i = at + (many_lines ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && opener == '"') {
      ++i;
    } else if (many_lines && text.substr(i, 3) == triple) {
      return i + 3;
    } else if (!many_lines && (text[i] == opener || text[i] == '\n')) {
      return i + 1;
    }
  }
  return text.size();
}

std::optional<Problem> refuse_depth(std::string_view text, const std::string& file) {
  int dots = 0;  // since the last key or value began
  int depth = 0;
  std::vector<int> open;  // what each open bracket adds to the depth: itself and the dots of its key
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t end = skip_quiet(text, at); end > at) {
      at = end;
      continue;
    }
    const char c = text[at];
    if (c == '.' && ++dots > most_dots) {
      return Problem{place_of(text, file, at), fmt::format("a key of more than {} parts", most_dots)};
    }
    if (c == '[' || c == '{') {
      open.push_back(1 + dots);
      depth += open.back();
      if (depth > deepest_nesting) {
        return Problem{place_of(text, file, at), fmt::format("tables and lists more than {} deep", deepest_nesting)};
      }
    }
    if ((c == ']' || c == '}') && !open.empty()) {
      depth -= open.back();
      open.pop_back();
    }
    if (c == ',' || c == '\n' || c == '[' || c == '{') dots = 0;
    ++at;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Problem> guard_toml(std::string_view text, const std::string& file, std::size_t most_bytes) {
  if (text.size() > most_bytes) {
    return Problem{{file},
                   fmt::format("the preset has {} bytes; at most {} KiB are read. Put long lists of points into a CSV "
                               "file",
                               text.size(), most_bytes / 1024)};
  }
  if (std::optional<Problem> problem = refuse_bytes(text, file)) return problem;
  return refuse_depth(text, file);
}

}  // namespace burin::preset
