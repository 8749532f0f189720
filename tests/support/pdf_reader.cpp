#include "support/pdf_reader.hpp"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <zlib.h>

#include <burin/base/utf8.hpp>

namespace burin::test {
namespace {

[[noreturn]] void fail(const std::string& why) {
  throw std::runtime_error("PDF: " + why);
}

std::string inflated(std::string_view packed) {
  std::string bytes;
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) fail("no zlib");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  int status = Z_OK;
  while (status == Z_OK) {
    char block[1 << 16];
    stream.next_out = reinterpret_cast<Bytef*>(block);
    stream.avail_out = sizeof block;
    status = inflate(&stream, Z_NO_FLUSH);
    bytes.append(block, sizeof block - stream.avail_out);
  }
  const bool whole = status == Z_STREAM_END && stream.avail_in == 0;
  inflateEnd(&stream);
  if (!whole) fail("a stream does not unpack");
  return bytes;
}

bool is_blank(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '\f' || c == '\0';
}
bool is_regular(char c) {
  return !is_blank(c) && std::string_view("()<>[]{}/%").find(c) == std::string_view::npos;
}

class Lexer {
 public:
  explicit Lexer(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  std::size_t at() const { return at_; }
  bool done() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    return at_ == text_.size();
  }
  bool take(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }
  void need(std::string_view word) {
    if (!take(word)) fail("expected '" + std::string(word) + "' at byte " + std::to_string(at_));
  }
  std::size_t count() {
    const std::string word = regular();
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) fail("'" + word + "' is no count");
    return value;
  }
  /// A value, or an operator as a PdfName with a leading blank.
  PdfValue value() {
    if (done()) fail("ends within a value");
    const char c = text_[at_];
    if (c == '/') return {name()};
    if (c == '(') return {literal()};
    if (c == '[') return {array()};
    if (text_.substr(at_, 2) == "<<") return {dictionary()};
    if (c == '<') return {hexadecimal()};
    return number_or_word();
  }
  PdfDictionary dictionary() {
    need("<<");
    PdfDictionary all;
    while (!done() && text_.substr(at_, 2) != ">>") {
      const PdfName key = name();
      if (!all.emplace(key.text, value()).second) fail("key " + key.text + " twice");
    }
    need(">>");
    return all;
  }

 private:
  std::string regular() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_regular(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }
  PdfName name() {
    need("/");
    PdfName read;
    const std::string raw = regular();
    for (std::size_t i = 0; i < raw.size(); ++i) {
      if (raw[i] == '#') {
        read.text += static_cast<char>(std::stoi(raw.substr(i + 1, 2), nullptr, 16));
        i += 2;
      } else {
        read.text += raw[i];
      }
    }
    return read;
  }
  std::string literal() {
    need("(");
    std::string read;
    for (;; ++at_) {
      if (at_ >= text_.size()) fail("an open string");
      const char c = text_[at_];
      if (c == ')') break;
      if (c == '(') fail("a bracket that is not escaped");
      if (c == '\r') fail("a carriage return that a reader changes");
      if (c != '\\') {
        read += c;
        continue;
      }
      const char escaped = text_[++at_];
      if (escaped != 'r' && escaped != '(' && escaped != ')' && escaped != '\\') fail("an escape that is no need");
      read += escaped == 'r' ? '\r' : escaped;
    }
    need(")");
    return read;
  }
  std::string hexadecimal() {
    need("<");
    const std::string digits = regular();
    need(">");
    std::string read;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
      read += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    }
    return read;
  }
  PdfArray array() {
    need("[");
    PdfArray all;
    while (!done() && text_[at_] != ']') all.push_back(value());
    need("]");
    return all;
  }
  PdfValue number_or_word() {
    const std::string word = regular();
    if (word.empty()) fail("an unexpected character at byte " + std::to_string(at_));
    if (word == "true" || word == "false") return {word == "true"};
    double number = 0.0;
    const char* const end = word.data() + word.size();
    if (word.find_first_not_of("-.0123456789") != std::string::npos) return {PdfName{' ' + word}};
    const auto [stopped, error] = std::from_chars(word.data(), end, number, std::chars_format::fixed);
    if (error != std::errc() || stopped != end || word == "-0") fail("'" + word + "' is no number");
    // "7 0 R"
    const std::size_t here = at_;
    if (!done() && take("0") && !done() && take("R") && (at_ == text_.size() || !is_regular(text_[at_]))) {
      return {PdfReference{static_cast<std::size_t>(number)}};
    }
    at_ = here;
    return {number};
  }

  std::string_view text_;
  std::size_t at_;
};

template <class T>
const T& as(const PdfValue& value) {
  const T* read = std::get_if<T>(&value.data);
  if (read == nullptr) fail("a value of another kind than expected");
  return *read;
}

}  // namespace

PdfFile::PdfFile(std::string_view bytes) {
  if (!bytes.starts_with("%PDF-1.5\n%\xE2\xE3\xCF\xD3\n")) fail("no header");
  constexpr std::string_view last = "startxref\n";
  const std::size_t tail = bytes.rfind(last);
  if (tail == std::string_view::npos) fail("no startxref");
  Lexer end(bytes, tail + last.size());
  const std::size_t table_at = end.count();
  end.need("\n%%EOF\n");
  if (end.at() != bytes.size()) fail("bytes behind the end");

  Lexer table(bytes, table_at);
  table.need("xref\n0 ");
  const std::size_t count = table.count();
  table.need("\n0000000000 65535 f \n");
  std::map<std::size_t, std::size_t> id_at;  // by offset
  for (std::size_t id = 1; id < count; ++id) {
    id_at[table.count()] = id;
    table.need(" 00000 n \n");
  }
  table.need("trailer\n");
  trailer_ = table.dictionary();
  table.need("\nstartxref");
  if (as<double>(trailer_.at("Size")) != static_cast<double>(count)) fail("/Size is not that of the table");

  std::size_t expected = 15;  // behind the header
  for (const auto& [offset, id] : id_at) {
    if (offset != expected) fail("object " + std::to_string(id) + " is not where the one before it ends");
    Lexer lexer(bytes, offset);
    lexer.need(std::to_string(id) + " 0 obj\n");
    Object object{lexer.value(), {}, 0};
    if (lexer.take("\nstream\n")) {
      const auto& entries = as<PdfDictionary>(object.value);
      object.stream_bytes = static_cast<std::size_t>(as<double>(entries.at("Length")));
      const std::string_view data = bytes.substr(lexer.at(), object.stream_bytes);
      object.stream = entries.contains("Filter") ? inflated(data) : std::string(data);
      lexer = Lexer(bytes, lexer.at() + object.stream_bytes);
      lexer.need("\nendstream");
    }
    lexer.need("\nendobj\n");
    expected = lexer.at();
    objects_[id] = std::move(object);
  }
  if (expected != table_at) fail("a gap before the table");
}

const PdfValue& PdfFile::resolved(const PdfValue& value) const {
  const PdfReference* reference = std::get_if<PdfReference>(&value.data);
  return reference == nullptr ? value : objects_.at(reference->id).value;
}

const PdfValue& PdfFile::entry(const PdfDictionary& dictionary, std::string_view key) const {
  const auto found = dictionary.find(std::string(key));
  if (found == dictionary.end()) fail("no entry " + std::string(key));
  return resolved(found->second);
}

const PdfDictionary& PdfFile::dictionary(const PdfDictionary& dictionary, std::string_view key) const {
  return as<PdfDictionary>(entry(dictionary, key));
}

std::vector<double> PdfFile::numbers(const PdfDictionary& dictionary, std::string_view key) const {
  std::vector<double> all;
  for (const PdfValue& value : as<PdfArray>(entry(dictionary, key))) all.push_back(as<double>(value));
  return all;
}

std::string PdfFile::text(const PdfDictionary& dictionary, std::string_view key) const {
  const std::string& raw = as<std::string>(entry(dictionary, key));
  if (!raw.starts_with("\xFE\xFF")) return raw;
  std::string text;
  const auto unit = [&](std::size_t i) {
    return static_cast<char32_t>(static_cast<unsigned char>(raw.at(i)) << 8U |
                                 static_cast<unsigned char>(raw.at(i + 1)));
  };
  for (std::size_t i = 2; i < raw.size(); i += 2) {
    char32_t code = unit(i);
    if (code >= 0xD800 && code < 0xDC00) {
      i += 2;
      code = 0x10000 + ((code - 0xD800) << 10U) + (unit(i) - 0xDC00);
    }
    text += utf8_text(code);
  }
  return text;
}

const PdfDictionary& PdfFile::catalog() const {
  return dictionary(trailer_, "Root");
}

const PdfDictionary& PdfFile::page() const {
  const PdfArray& kids = as<PdfArray>(entry(dictionary(catalog(), "Pages"), "Kids"));
  if (kids.size() != 1) fail("not one page");
  return as<PdfDictionary>(resolved(kids.front()));
}

std::vector<std::string> PdfFile::layer_names() const {
  std::vector<std::string> names;
  const PdfDictionary& layers = dictionary(catalog(), "OCProperties");
  const PdfArray& order = as<PdfArray>(entry(dictionary(layers, "D"), "Order"));
  if (as<PdfArray>(entry(layers, "OCGs")).size() != order.size()) fail("layers that are not listed");
  for (const PdfValue& layer : order) names.push_back(text(as<PdfDictionary>(resolved(layer)), "Name"));
  return names;
}

namespace {

/// Runs content streams.
class Interpreter {
 public:
  explicit Interpreter(const PdfFile& file) : file_(file) {
    const PdfDictionary& page = file.page();
    const std::vector<double> trim = file.numbers(page, page.contains("TrimBox") ? "TrimBox" : "MediaBox");
    constexpr double mm_per_point = 25.4 / 72.0;
    mm_from_points_ = scaling(mm_per_point, -mm_per_point) * translation({-trim.at(0), -trim.at(3)});
  }

  void run(const std::string& content, const PdfDictionary& resources) {
    const std::size_t depth = saved_.size();
    const std::size_t layers = layers_.size();
    Lexer lexer(content);
    while (!lexer.done()) {
      PdfValue value = lexer.value();
      const PdfName* word = std::get_if<PdfName>(&value.data);
      if (word == nullptr || !word->text.starts_with(' ')) {
        operands_.push_back(std::move(value));
        continue;
      }
      run_operator(word->text.substr(1), resources);
      if (!operands_.empty()) fail("operands too many for " + word->text);
      if (saved_.size() < depth) fail("Q without q");
    }
    if (saved_.size() != depth || layers_.size() != layers || !path_.empty()) fail("a stream that is not balanced");
  }

  std::vector<PdfPainted> all;

 private:
  struct State {
    Affine2 points_from_user{};
    PdfStyle style{};
  };

  double number() {
    if (operands_.empty()) fail("an operand is missing");
    const double value = as<double>(operands_.back());
    operands_.pop_back();
    return value;
  }
  std::string name() {
    if (operands_.empty()) fail("an operand is missing");
    const std::string text = as<PdfName>(operands_.back()).text;
    operands_.pop_back();
    return text;
  }
  Vec2 point() {
    const double y = number();
    return mm_from_points_(state_.points_from_user({number(), y}));
  }
  std::string colour(const std::string& by) {
    std::string text;
    for (const PdfValue& value : operands_) {
      const double share = as<double>(value);
      if (share < 0.0 || share > 1.0) fail("a colour outside of 0 to 1");
      text += std::to_string(std::lround(share * 1e4)) + ' ';
    }
    operands_.clear();
    return text + by;
  }
  void begin_path_operator(bool painting) {
    if (painting == path_.empty()) fail(painting ? "painting without a path" : "an operator within a path");
  }
  void paint(const std::string& by) {
    begin_path_operator(true);
    all.push_back({by, layers_.empty() ? "" : layers_.back(), group_, state_.style, std::move(path_)});
    path_.clear();
  }

  void run_operator(const std::string& by, const PdfDictionary& resources) {
    PdfStyle& style = state_.style;
    const double scale = state_.points_from_user.scale();
    const auto takes = [&](std::size_t count) {
      if (operands_.size() != count) fail("wrong number of operands of " + by);
    };
    if (by == "m") {
      takes(2);
      path_.push_back({{point()}, false});
    } else if (by == "l") {
      takes(2);
      if (path_.empty() || path_.back().closed) fail("a line from nowhere");
      path_.back().points.push_back(point());
    } else if (by == "h") {
      takes(0);
      path_.back().closed = true;
    } else if (by == "re") {
      takes(4);
      const double height = number();
      const double width = number();
      const double y = number();
      const double x = number();
      PdfContour box{{}, true};
      for (const Vec2 p : {Vec2{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}}) {
        box.points.push_back(mm_from_points_(state_.points_from_user(p)));
      }
      path_.push_back(box);
    } else if (by == "S" || by == "f" || by == "f*") {
      takes(0);
      paint(by);
    } else if (by == "W") {
      takes(0);
      begin_path_operator(true);
    } else if (by == "n") {
      takes(0);
      path_.clear();
    } else {
      begin_path_operator(false);
      if (by == "q") {
        takes(0);
        saved_.push_back(state_);
      } else if (by == "Q") {
        takes(0);
        if (saved_.empty()) fail("Q without q");
        state_ = saved_.back();
        saved_.pop_back();
      } else if (by == "cm") {
        takes(6);
        Affine2 m;
        for (double* part : {&m.f, &m.e, &m.d, &m.c, &m.b, &m.a}) *part = number();
        state_.points_from_user = state_.points_from_user * m;
      } else if (by == "w") {
        takes(1);
        style.width = number() * scale;
      } else if (by == "J") {
        takes(1);
        style.cap = static_cast<int>(number());
      } else if (by == "j") {
        takes(1);
        style.join = static_cast<int>(number());
      } else if (by == "M") {
        takes(1);
        style.miter = number();
      } else if (by == "d") {
        takes(2);
        style.dash_offset = number() * scale;
        style.dashes.clear();
        for (const PdfValue& dash : as<PdfArray>(operands_.back())) style.dashes.push_back(as<double>(dash) * scale);
        operands_.clear();
      } else if (by == "G" || by == "RG" || by == "K") {
        takes(by == "G" ? 1 : by == "RG" ? 3 : 4);
        style.line_colour = colour(by);
      } else if (by == "g" || by == "rg" || by == "k") {
        takes(by == "g" ? 1 : by == "rg" ? 3 : 4);
        style.fill_colour = colour(by);
      } else if (by == "CS" || by == "cs") {
        takes(1);
        (by == "CS" ? line_space_ : fill_space_) = space(name(), resources);
      } else if (by == "SCN" || by == "scn") {
        takes(1);
        (by == "SCN" ? style.line_colour : style.fill_colour) = colour(by == "SCN" ? line_space_ : fill_space_);
      } else if (by == "BDC") {
        takes(2);
        const std::string property = name();
        if (name() != "OC") fail("marked content that is no layer");
        layers_.push_back(file_.text(file_.dictionary(file_.dictionary(resources, "Properties"), property), "Name"));
      } else if (by == "EMC") {
        takes(0);
        if (layers_.empty()) fail("EMC without BDC");
        layers_.pop_back();
      } else if (by == "gs") {
        takes(1);
        const PdfDictionary& state = file_.dictionary(file_.dictionary(resources, "ExtGState"), name());
        style.opacity = as<double>(file_.entry(state, "ca"));
        if (as<double>(file_.entry(state, "CA")) != style.opacity) fail("two opacities");
      } else if (by == "Do") {
        takes(1);
        run_form(file_.dictionary(resources, "XObject").at(name()));
      } else {
        fail("unknown operator '" + by + "'");
      }
    }
  }

  std::string space(const std::string& name, const PdfDictionary& resources) {
    const PdfArray& space = as<PdfArray>(file_.entry(file_.dictionary(resources, "ColorSpace"), name));
    if (as<PdfName>(space.at(0)).text != "Separation") fail("a colour space that is no Separation");
    return as<PdfName>(space.at(1)).text;
  }

  void run_form(const PdfValue& reference) {
    const PdfFile::Object& form = file_.object(as<PdfReference>(reference).id);
    const auto& entries = as<PdfDictionary>(form.value);
    if (as<PdfName>(entries.at("Subtype")).text != "Form") fail("an XObject that is no form");
    if (file_.numbers(entries, "BBox").size() != 4) fail("a form without its box");
    const State before = state_;
    const std::size_t outside = group_;
    if (entries.contains("Group")) group_ = ++groups_;
    run(form.stream, file_.dictionary(entries, "Resources"));
    group_ = outside;
    state_ = before;
  }

  const PdfFile& file_;
  Affine2 mm_from_points_;
  State state_;
  std::vector<State> saved_;
  std::vector<std::string> layers_;
  std::vector<PdfValue> operands_;
  std::vector<PdfContour> path_;
  std::string line_space_;
  std::string fill_space_;
  std::size_t group_ = 0;
  std::size_t groups_ = 0;
};

}  // namespace

std::vector<PdfPainted> painted(const PdfFile& file) {
  Interpreter interpreter(file);
  std::string content;
  for (const PdfValue& stream : as<PdfArray>(file.entry(file.page(), "Contents"))) {
    content += file.object(as<PdfReference>(stream).id).stream + '\n';
  }
  interpreter.run(content, file.dictionary(file.page(), "Resources"));
  return std::move(interpreter.all);
}

}  // namespace burin::test
