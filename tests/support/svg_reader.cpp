#include "support/svg_reader.hpp"

#include <charconv>
#include <cstdint>
#include <stdexcept>

namespace burin::test {

namespace {

[[noreturn]] void fail(const std::string& what, std::size_t at) {
  throw std::runtime_error(what + " at byte " + std::to_string(at));
}

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) { check_characters(); }

  XmlElement document() {
    const std::string_view declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    if (!text_.starts_with(declaration)) fail("no XML declaration", 0);
    at_ = declaration.size();
    XmlElement root = element({});
    skip_space();
    if (at_ != text_.size()) fail("text after the root", at_);
    return root;
  }

 private:
  using Prefixes = std::map<std::string, std::string>;

  /// UTF-8 of characters that XML 1.0 allows, section 2.2.
  void check_characters() const {
    for (std::size_t i = 0; i < text_.size();) {
      const auto byte = static_cast<unsigned char>(text_[i]);
      const std::size_t length = byte < 0x80 ? 1 : byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
      if (byte >= 0x80 && (byte < 0xC2 || byte > 0xF4)) fail("a byte that begins no character", i);
      if (i + length > text_.size()) fail("half a character", i);
      std::uint32_t code = length == 1 ? byte : byte & (0x7FU >> length);
      for (std::size_t k = 1; k < length; ++k) {
        const auto next = static_cast<unsigned char>(text_[i + k]);
        if ((next & 0xC0U) != 0x80U) fail("a broken character", i);
        code = code << 6U | (next & 0x3FU);
      }
      const bool control = code < 0x20 && code != '\t' && code != '\n' && code != '\r';
      if (control || code == 0xFFFE || code == 0xFFFF || (code >= 0xD800 && code <= 0xDFFF)) {
        fail("a character that XML refuses", i);
      }
      i += length;
    }
  }

  char peek() const {
    if (at_ >= text_.size()) fail("an early end", at_);
    return text_[at_];
  }
  void expect(std::string_view what) {
    if (!text_.substr(at_).starts_with(what)) fail("no '" + std::string(what) + "'", at_);
    at_ += what.size();
  }
  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  std::string name() {
    const std::size_t begin = at_;
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    while (is_letter(peek()) || (at_ > begin && (peek() == ':' || peek() == '-' || (peek() >= '0' && peek() <= '9')))) {
      ++at_;
    }
    if (at_ == begin) fail("no name", at_);
    return std::string(text_.substr(begin, at_ - begin));
  }

  void check_prefix(const std::string& qualified, const Prefixes& prefixes) const {
    const std::size_t colon = qualified.find(':');
    if (colon == std::string::npos) return;
    const std::string prefix = qualified.substr(0, colon);
    if (prefix != "xml" && prefix != "xmlns" && !prefixes.contains(prefix)) fail("undeclared prefix " + prefix, at_);
  }

  std::string entity() {
    expect("&");
    const std::size_t end = text_.find(';', at_);
    if (end == std::string_view::npos) fail("an open entity", at_);
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end + 1;
    if (word == "amp") return "&";
    if (word == "lt") return "<";
    if (word == "gt") return ">";
    if (word == "quot") return "\"";
    if (word == "#13") return "\r";
    if (word == "#10") return "\n";
    if (word == "#9") return "\t";
    fail("unknown entity " + std::string(word), at_);
  }

  XmlElement element(Prefixes prefixes) {
    XmlElement read;
    expect("<");
    read.name = name();
    while (is_space(peek())) {
      skip_space();
      if (peek() == '/' || peek() == '>') fail("space before the tag's end", at_);
      const std::string key = name();
      expect("=\"");
      std::string value;
      while (peek() != '"') {
        if (peek() == '<') fail("'<' in an attribute", at_);
        value += peek() == '&' ? entity() : std::string(1, text_[at_++]);
      }
      expect("\"");
      if (key.starts_with("xmlns:")) prefixes[key.substr(6)] = value;
      if (!read.attributes.emplace(key, value).second) fail("attribute " + key + " twice", at_);
    }
    check_prefix(read.name, prefixes);
    for (const auto& [key, value] : read.attributes) check_prefix(key, prefixes);
    if (peek() == '/') {
      expect("/>");
      return read;
    }
    expect(">");
    while (!text_.substr(at_).starts_with("</")) {
      if (peek() == '<') {
        read.children.push_back(element(prefixes));
      } else if (peek() == '&') {
        read.text += entity();
      } else {
        if (text_.substr(at_).starts_with("]]>")) fail("']]>' in text", at_);
        read.text += text_[at_++];
      }
    }
    expect("</" + read.name + ">");
    return read;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

class PathReader {
 public:
  explicit PathReader(std::string_view data) : data_(data) {}

  std::vector<ReadContour> contours() {
    while (at_ < data_.size()) {
      char command = data_[at_++];
      if (command == 'z' || command == 'Z') {
        contour().closed = true;
        here_ = contour().points.front();
        moved_ = false;
        continue;
      }
      before_ = Before::command;
      do {
        step(command);
      } while (number_follows());
    }
    return contours_;
  }

 private:
  enum class Before { command, whole, pointed };

  ReadContour& contour() {
    if (contours_.empty()) fail("no move first", at_);
    return contours_.back();
  }

  /// One step of `command`, which becomes what its repetition means.
  void step(char& command) {
    switch (command) {
      case 'm':
      case 'M':
        here_ = point(command == 'm');
        contours_.push_back({{here_}, false});
        moved_ = true;
        command = command == 'm' ? 'l' : 'L';
        return;
      case 'l':
      case 'L':
        here_ = point(command == 'l');
        break;
      case 'h':
      case 'H':
        here_.x = (command == 'h' ? here_.x : 0.0) + number();
        break;
      case 'v':
      case 'V':
        here_.y = (command == 'v' ? here_.y : 0.0) + number();
        break;
      default:
        fail(std::string("unknown command ") + command, at_);
    }
    if (!moved_) fail("a line after z without a move", at_);
    contour().points.push_back(here_);
  }

  Vec2 point(bool relative) {
    const double x = number();
    const double y = number();
    return relative ? here_ + Vec2{x, y} : Vec2{x, y};
  }

  bool number_follows() const {
    if (at_ >= data_.size()) return false;
    const char c = data_[at_];
    return c == ' ' || c == '-' || c == '.' || (c >= '0' && c <= '9');
  }

  double number() {
    const bool spaced = at_ < data_.size() && data_[at_] == ' ';
    if (spaced) ++at_;
    const std::size_t begin = at_;
    const auto digits = [&] {
      const std::size_t first = at_;
      while (at_ < data_.size() && data_[at_] >= '0' && data_[at_] <= '9') ++at_;
      return data_.substr(first, at_ - first);
    };
    const bool negative = at_ < data_.size() && data_[at_] == '-';
    if (negative) ++at_;
    const std::size_t unsigned_begin = at_;
    const std::string_view whole = digits();
    const bool pointed = at_ < data_.size() && data_[at_] == '.';
    if (pointed) ++at_;
    const std::string_view fraction = pointed ? digits() : std::string_view{};
    const std::string_view text = data_.substr(begin, at_ - begin);

    if (whole.empty() && fraction.empty()) fail("no number", begin);
    if (pointed && (fraction.empty() || fraction.back() == '0')) fail("zeros without need", begin);
    if (whole.starts_with('0') && (whole.size() > 1 || pointed)) fail("a leading zero", begin);
    if (negative && text == "-0") fail("-0", begin);
    const bool needs_space =
        before_ != Before::command && !negative && !(data_[unsigned_begin] == '.' && before_ == Before::pointed);
    if (spaced != needs_space) fail(spaced ? "a space without need" : "a missing space", begin);
    before_ = pointed ? Before::pointed : Before::whole;

    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }

  std::string_view data_;
  std::size_t at_ = 0;
  Before before_ = Before::command;
  bool moved_ = false;
  Vec2 here_;
  std::vector<ReadContour> contours_;
};

}  // namespace

const XmlElement& XmlElement::child(std::string_view child_name) const {
  const XmlElement* found = nullptr;
  for (const XmlElement& candidate : children) {
    if (candidate.name != child_name) continue;
    if (found != nullptr) throw std::runtime_error("two children " + std::string(child_name));
    found = &candidate;
  }
  if (found == nullptr) throw std::runtime_error("no child " + std::string(child_name));
  return *found;
}

const std::string& XmlElement::at(std::string_view attribute) const {
  const auto found = attributes.find(std::string(attribute));
  if (found == attributes.end()) throw std::runtime_error("no attribute " + std::string(attribute));
  return found->second;
}

XmlElement read_xml(std::string_view text) {
  return XmlReader(text).document();
}

std::vector<ReadContour> read_path_data(std::string_view data) {
  return PathReader(data).contours();
}

std::string exact_text(std::string_view escaped) {
  std::string text;
  for (std::size_t i = 0; i < escaped.size(); ++i) {
    if (escaped[i] != '\\') {
      text += escaped[i];
    } else if (escaped.at(i + 1) == '\\') {
      text += '\\';
      ++i;
    } else {
      unsigned byte = 0;
      if (escaped.at(i + 1) != 'x') fail("unknown escape", i);
      std::from_chars(escaped.data() + i + 2, escaped.data() + i + 4, byte, 16);
      text += static_cast<char>(byte);
      i += 3;
    }
  }
  return text;
}

}  // namespace burin::test
