#include <algorithm>
#include <pugixml.hpp>
#include <utility>

#include <burin/data/xml.hpp>

namespace burin::data {

namespace {

constexpr std::size_t max_bytes = std::size_t{8} << 20U;

pugi::xml_node node_of(void* node) {
  return pugi::xml_node(static_cast<pugi::xml_node_struct*>(node));
}

XmlElement element_of(pugi::xml_node node) {
  return XmlElement(node.internal_object());
}

/// This node, or the first element among its later siblings.
XmlElement element_from(pugi::xml_node node) {
  while (node && node.type() != pugi::node_element) node = node.next_sibling();
  return element_of(node);
}

}  // namespace

std::string_view XmlElement::name() const {
  return node_of(node_).name();
}

std::string_view XmlElement::local_name() const {
  const std::string_view whole = name();
  const std::size_t colon = whole.find(':');
  return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

std::optional<std::string_view> XmlElement::attribute(std::string_view name) const {
  for (const pugi::xml_attribute& attribute : node_of(node_).attributes()) {
    if (attribute.name() == name) return attribute.value();
  }
  return std::nullopt;
}

std::size_t XmlElement::attribute_bytes() const {
  std::size_t sum = 0;
  for (const pugi::xml_attribute& attribute : node_of(node_).attributes()) {
    sum += std::string_view(attribute.name()).size() + std::string_view(attribute.value()).size();
  }
  return sum;
}

XmlElement XmlElement::parent() const {
  const pugi::xml_node parent = node_of(node_).parent();
  return parent.type() == pugi::node_element ? element_of(parent) : XmlElement();
}

XmlElement XmlElement::first_child() const {
  return element_from(node_of(node_).first_child());
}

XmlElement XmlElement::next_sibling() const {
  return element_from(node_of(node_).next_sibling());
}

XmlElement XmlElement::next_within(const XmlElement& root) const {
  if (const XmlElement child = first_child()) return child;
  for (XmlElement up = *this; up && up != root; up = up.parent()) {
    if (const XmlElement next = up.next_sibling()) return next;
  }
  return {};
}

std::string XmlElement::text() const {
  std::string all;
  for (const pugi::xml_node& child : node_of(node_).children()) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) all += child.value();
  }
  return all;
}

std::size_t XmlElement::offset() const {
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(node_of(node_).offset_debug(), 0));
}

struct XmlDocument::Tree {
  pugi::xml_document document;
};

Result<XmlDocument> XmlDocument::parse(std::string_view text, const std::string& file) {
  if (text.size() > max_bytes)
    return Problem{{file}, "is larger than the 8 MiB that an XML file may have", Trouble::limit};
  if (text.find('\0') != std::string_view::npos) {
    return Problem{{file}, "holds zero bytes, so it is no text in UTF-8; save it as UTF-8"};
  }
  XmlDocument read;
  read.file_ = file;
  read.line_starts_.push_back(0);
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
    read.line_starts_.push_back(at + 1);
  }
  const auto tree = std::make_shared<Tree>();
  const pugi::xml_parse_result result =
      tree->document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0));
    return Problem{read.at(std::min(offset, text.size())),
                   std::string("is no well-formed XML: ") + result.description()};
  }
  read.tree_ = tree;
  return read;
}

XmlElement XmlDocument::root() const {
  return element_of(tree_->document.document_element());
}

Where XmlDocument::where(const XmlElement& element) const {
  return at(element.offset());
}

Where XmlDocument::at(std::size_t offset) const {
  const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = static_cast<int>(next - line_starts_.begin());
  return {file_, line, static_cast<int>(offset - line_starts_[static_cast<std::size_t>(line) - 1]) + 1};
}

}  // namespace burin::data
