#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cli/recover/bytes_at.hpp>

namespace burin::cli {

/// Walks through the tags of an XML document of any size and depth. It knows namespaces, keeps no attributes, and
/// believes what need not be checked to find an element.
class XmlScanner {
 public:
  explicit XmlScanner(const BytesAt& bytes) : in_(bytes) {}

  enum class Kind : std::uint8_t {
    begin,     ///< <name> or, `empty`, <name/>
    end,       ///< </name>
    finished,  ///< the document ends between two tags
    broken,    ///< it ends inside of one, or is no XML
  };
  struct Tag {
    Kind kind = Kind::finished;
    std::string space;  ///< the namespace of a beginning, as its prefix is declared
    std::string name;   ///< without prefix; cut after some hundred bytes
    bool empty = false;
  };

  Tag next_tag();

  /// The characters between a beginning and the end that belongs to it; entities are resolved, comments and processing
  /// instructions left out. Nothing when the document is broken there, an element is inside, or the text is longer than
  /// `limit`. Call it right after next_tag() gave a beginning that is not empty.
  std::optional<std::string> text_content(std::size_t limit);

 private:
  /// `xmlns:prefix="space"`, in force until the element at `depth` ends.
  struct Binding {
    std::uint64_t depth;
    std::string prefix;
    std::string space;
  };

  Tag begin_tag();
  Tag end_tag();
  /// Behind "<!" or "<?". False: it does not end.
  bool skip_aside(std::string* character_data, std::size_t limit);
  bool skip_doctype();
  std::string take_name();
  void skip_blanks();
  std::string space_of(std::string_view prefix) const;

  ByteStreamIn in_;
  std::uint64_t depth_ = 0;
  std::vector<Binding> bindings_;
};

}  // namespace burin::cli
