#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>

namespace burin::data {

/// An element of an XmlDocument, or none. A handle: it lives as long as its document, as do the texts it hands out.
class XmlElement {
 public:
  XmlElement() = default;
  explicit XmlElement(void* node) : node_(node) {}

  explicit operator bool() const { return node_ != nullptr; }
  friend bool operator==(const XmlElement&, const XmlElement&) = default;

  /// As written, with its prefix: "svg:path".
  std::string_view name() const;
  /// Without its prefix: "path".
  std::string_view local_name() const;
  /// The value of the attribute written so; nothing when there is none.
  std::optional<std::string_view> attribute(std::string_view name) const;

  /// The text of all attributes, names included.
  std::size_t attribute_bytes() const;

  /// Neighbours that are elements; none at the end.
  XmlElement parent() const;
  XmlElement first_child() const;
  XmlElement next_sibling() const;
  /// The element after this one in the order of the text, not leaving `root`; none at the end. O(1) on average.
  XmlElement next_within(const XmlElement& root) const;

  /// Its own character data, without that of its children.
  std::string text() const;
  /// Where its name stands in the document's text, in bytes.
  std::size_t offset() const;

 private:
  void* node_ = nullptr;
};

/// A parsed XML text. Entities of its own are left as they are written: nothing grows while it is read.
class XmlDocument {
 public:
  /// Problems carry `file`, line and column. At most 8 MiB; any depth. Memory: about twenty times the text at worst.
  static Result<XmlDocument> parse(std::string_view text, const std::string& file);

  XmlElement root() const;
  /// The place of an element in the text.
  Where where(const XmlElement& element) const;

 private:
  struct Tree;
  XmlDocument() = default;
  Where at(std::size_t offset) const;

  std::shared_ptr<const Tree> tree_;
  std::string file_;
  std::vector<std::size_t> line_starts_;
};

}  // namespace burin::data
