#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace burin::cli {

struct PdfObject;
struct PdfEntry;

struct PdfName {
  std::string name;
};
struct PdfReference {
  std::uint64_t number = 0;
  std::uint64_t generation = 0;
};
using PdfArray = std::vector<PdfObject>;
/// Keys as they come; the first of a name counts.
struct PdfDictionary {
  std::vector<PdfEntry> entries;

  const PdfObject* find(std::string_view key) const;
};

/// An object of a PDF (ISO 32000-1, section 7.3): null, true and false are names here; a stream is its dictionary.
struct PdfObject {
  std::variant<PdfName, double, std::string, PdfReference, PdfArray, PdfDictionary> value;

  template <class T>
  const T* as() const {
    return std::get_if<T>(&value);
  }
  /// The number as a count or an offset; nothing when it is no whole number from 0 to 2^53.
  std::optional<std::uint64_t> as_count() const;
};

struct PdfEntry {
  std::string key;
  PdfObject value;
};

/// Takes a text of PDF syntax apart, from left to right.
class PdfLexer {
 public:
  explicit PdfLexer(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  std::size_t at() const { return at_; }
  /// Blanks and comments.
  void skip_blanks();
  /// Takes this word if it comes next.
  bool take_word(std::string_view word);
  std::optional<std::uint64_t> take_count();

  /// The next object; nothing when there is none, when it does not end in the text, when it is nested too deep or has
  /// too many parts.
  std::optional<PdfObject> object(int depth = 0);

 private:
  std::optional<PdfObject> array(int depth);
  std::optional<PdfObject> dictionary(int depth);
  std::optional<PdfObject> number_or_reference();
  std::optional<std::string> literal_string();
  std::optional<std::string> hexadecimal_string();
  std::string name();
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool at_end() const { return at_ >= text_.size(); }

  std::string_view text_;
  std::size_t at_;
  int parts_left_ = 100'000;
};

/// A text string (section 7.9.2.2) in UTF-8: UTF-16 with a byte order mark, UTF-8 with one, else PDFDocEncoding.
/// Nothing for lone surrogates and codes without a character.
std::optional<std::string> utf8_of_pdf_text(std::string_view bytes);

}  // namespace burin::cli
