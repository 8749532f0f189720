#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <burin/geom/affine2.hpp>

/// A small strict reader of PDF that tests hold written files against: the file's skeleton, and what its page paints.
/// All throw std::runtime_error on what is not well formed.
namespace burin::test {

struct PdfName {
  std::string text;
};
struct PdfReference {
  std::size_t id = 0;
};
struct PdfValue;
using PdfArray = std::vector<PdfValue>;
using PdfDictionary = std::map<std::string, PdfValue>;

struct PdfValue {
  std::variant<std::monostate, bool, double, PdfName, std::string, PdfReference, PdfArray, PdfDictionary> data{};
};

/// A whole file: header, objects without gaps between them, a table whose every offset is right, trailer.
class PdfFile {
 public:
  struct Object {
    PdfValue value;
    std::string stream;            ///< unpacked
    std::size_t stream_bytes = 0;  ///< as they stand in the file
  };

  explicit PdfFile(std::string_view bytes);

  const PdfDictionary& trailer() const { return trailer_; }
  std::size_t object_count() const { return objects_.size(); }
  const Object& object(std::size_t id) const { return objects_.at(id); }

  /// The value, following a reference.
  const PdfValue& resolved(const PdfValue& value) const;
  /// An entry of a dictionary, following references; throws when it is missing.
  const PdfValue& entry(const PdfDictionary& dictionary, std::string_view key) const;
  const PdfDictionary& dictionary(const PdfDictionary& dictionary, std::string_view key) const;
  std::vector<double> numbers(const PdfDictionary& dictionary, std::string_view key) const;
  /// A string as UTF-8, from ASCII or UTF-16.
  std::string text(const PdfDictionary& dictionary, std::string_view key) const;

  const PdfDictionary& catalog() const;
  /// The only page.
  const PdfDictionary& page() const;
  /// The layers' names as programs list them.
  std::vector<std::string> layer_names() const;

 private:
  PdfDictionary trailer_;
  std::map<std::size_t, Object> objects_;
};

struct PdfStyle {
  double width = 1.0;  ///< in units of the page's own space, a point
  int cap = 0;
  int join = 0;
  double miter = 10.0;
  std::vector<double> dashes{};  ///< likewise
  double dash_offset = 0.0;
  std::string line_colour = "0 G";
  std::string fill_colour = "0 g";
  double opacity = 1.0;
};

struct PdfContour {
  std::vector<Vec2> points;  ///< millimetres from the top left corner of the trimmed page, y down
  bool closed = false;
};

/// What one painting operator paints.
struct PdfPainted {
  std::string by;         ///< "S", "f" or "f*"
  std::string layer;      ///< empty: none
  std::size_t group = 0;  ///< 0: the page itself; else which transparency group, from 1
  PdfStyle style{};
  std::vector<PdfContour> contours{};
};

/// Everything the page paints, in order. Operators must be known, have the right operands, and be balanced within each
/// form and over the page; names must be resources.
std::vector<PdfPainted> painted(const PdfFile& file);

}  // namespace burin::test
