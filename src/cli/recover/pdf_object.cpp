#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include <burin/base/number_text.hpp>
#include <cli/recover/pdf_object.hpp>

namespace burin::cli {

namespace {

constexpr int deepest = 64;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\0';
}

bool is_delimiter(char c) {
  return std::string_view("()<>[]{}/%").find(c) != std::string_view::npos;
}

bool is_regular(char c) {
  return !is_blank(c) && !is_delimiter(c);
}

std::optional<unsigned> hexadecimal_digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a') + 10;
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A') + 10;
  return std::nullopt;
}

}  // namespace

const PdfObject* PdfDictionary::find(std::string_view key) const {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const PdfEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

std::optional<std::uint64_t> PdfObject::as_count() const {
  constexpr double most = 9007199254740992.0;
  const double* number = as<double>();
  if (number == nullptr || !(*number >= 0.0 && *number <= most) || *number != std::floor(*number)) return std::nullopt;
  return static_cast<std::uint64_t>(*number);
}

void PdfLexer::skip_blanks() {
  while (!at_end()) {
    if (peek() == '%') {
      while (!at_end() && peek() != '\n' && peek() != '\r') ++at_;
    } else if (is_blank(peek())) {
      ++at_;
    } else {
      return;
    }
  }
}

bool PdfLexer::take_word(std::string_view word) {
  skip_blanks();
  if (text_.substr(at_, word.size()) != word) return false;
  const bool ends = at_ + word.size() >= text_.size() || !is_regular(text_[at_ + word.size()]);
  if (!ends) return false;
  at_ += word.size();
  return true;
}

std::optional<std::uint64_t> PdfLexer::take_count() {
  skip_blanks();
  std::uint64_t count = 0;
  const char* begin = text_.data() + at_;
  const auto [stopped, error] = std::from_chars(begin, text_.data() + text_.size(), count);
  if (error != std::errc()) return std::nullopt;
  at_ += static_cast<std::size_t>(stopped - begin);
  return count;
}

std::optional<PdfObject> PdfLexer::object(int depth) {
  skip_blanks();
  if (at_end() || depth > deepest || --parts_left_ < 0) return std::nullopt;
  const char c = peek();
  if (c == '(') {
    std::optional<std::string> text = literal_string();
    return text ? std::optional(PdfObject{*std::move(text)}) : std::nullopt;
  }
  if (c == '<' && peek(1) == '<') return dictionary(depth);
  if (c == '<') {
    std::optional<std::string> text = hexadecimal_string();
    return text ? std::optional(PdfObject{*std::move(text)}) : std::nullopt;
  }
  if (c == '[') return array(depth);
  if (c == '/') return PdfObject{PdfName{name()}};
  if ((c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.') return number_or_reference();
  for (const std::string_view word : {"true", "false", "null"}) {
    if (take_word(word)) return PdfObject{PdfName{std::string(word)}};
  }
  return std::nullopt;
}

std::optional<PdfObject> PdfLexer::array(int depth) {
  ++at_;
  PdfArray items;
  for (;;) {
    skip_blanks();
    if (peek() == ']') {
      ++at_;
      return PdfObject{std::move(items)};
    }
    std::optional<PdfObject> item = object(depth + 1);
    if (!item) return std::nullopt;
    items.push_back(*std::move(item));
  }
}

std::optional<PdfObject> PdfLexer::dictionary(int depth) {
  at_ += 2;
  PdfDictionary dictionary;
  for (;;) {
    skip_blanks();
    if (peek() == '>' && peek(1) == '>') {
      at_ += 2;
      return PdfObject{std::move(dictionary)};
    }
    if (peek() != '/') return std::nullopt;
    std::string key = name();
    std::optional<PdfObject> value = object(depth + 1);
    if (!value) return std::nullopt;
    dictionary.entries.push_back({std::move(key), *std::move(value)});
  }
}

std::optional<PdfObject> PdfLexer::number_or_reference() {
  const std::size_t begin = at_;
  if (const std::optional<std::uint64_t> number = take_count()) {
    const std::size_t behind = at_;
    const std::optional<std::uint64_t> generation = is_blank(peek()) ? take_count() : std::nullopt;
    if (generation && take_word("R")) return PdfObject{PdfReference{*number, *generation}};
    at_ = behind;
  }
  std::size_t end = begin;
  while (end < text_.size() && is_regular(text_[end])) ++end;
  std::string_view digits = text_.substr(begin, end - begin);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  if (digits.ends_with('.')) digits.remove_suffix(1);
  const std::optional<double> number = parse_number(digits);
  if (!number) return std::nullopt;
  at_ = end;
  return PdfObject{*number};
}

std::string PdfLexer::name() {
  ++at_;
  std::string name;
  while (!at_end() && is_regular(peek())) {
    const std::optional<unsigned> high = peek() == '#' ? hexadecimal_digit(peek(1)) : std::nullopt;
    const std::optional<unsigned> low = high ? hexadecimal_digit(peek(2)) : std::nullopt;
    name += low ? static_cast<char>(*high << 4U | *low) : peek();
    at_ += low ? 3 : 1;
  }
  return name;
}

/// (a text with \escapes, (balanced) parentheses and line ends of any kind)
std::optional<std::string> PdfLexer::literal_string() {
  std::string text;
  int open = 0;
  while (!at_end()) {
    const char c = text_[at_++];
    if (c == '(' && ++open == 1) continue;
    if (c == ')' && --open == 0) return text;
    if (c == '\r') {
      if (peek() == '\n') ++at_;
      text += '\n';
    } else if (c != '\\') {
      text += c;
    } else if (peek() >= '0' && peek() <= '7') {
      unsigned code = 0;
      for (int digit = 0; digit < 3 && peek() >= '0' && peek() <= '7'; ++digit) {
        code = code * 8 + static_cast<unsigned>(text_[at_++] - '0');
      }
      text += static_cast<char>(code & 0xFFU);
    } else {
      constexpr std::string_view letters = "nrtbf";
      constexpr std::string_view meanings = "\n\r\t\b\f";
      const char escaped = at_end() ? '\0' : text_[at_++];
      const std::size_t letter = letters.find(escaped);
      if (escaped == '\r' && peek() == '\n') ++at_;
      if (escaped == '\r' || escaped == '\n') continue;  // the line goes on
      text += letter != std::string_view::npos ? meanings[letter] : escaped;
    }
  }
  return std::nullopt;
}

std::optional<std::string> PdfLexer::hexadecimal_string() {
  ++at_;
  std::string text;
  std::optional<unsigned> high;
  while (!at_end()) {
    const char c = text_[at_++];
    if (is_blank(c)) continue;
    if (c == '>') {
      if (high) text += static_cast<char>(*high << 4U);
      return text;
    }
    const std::optional<unsigned> digit = hexadecimal_digit(c);
    if (!digit) return std::nullopt;
    if (high) text += static_cast<char>(*high << 4U | *digit);
    high = high ? std::nullopt : digit;
  }
  return std::nullopt;
}

}  // namespace burin::cli
