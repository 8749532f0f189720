#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <burin/geom/vec2.hpp>

/// Small strict readers that tests hold written files against. All throw std::runtime_error on what is not well formed.
namespace burin::test {

struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< the characters directly inside, entities resolved
  std::vector<XmlElement> children;

  /// The only child of this name; throws when there is none or more.
  const XmlElement& child(std::string_view child_name) const;
  bool has(std::string_view attribute) const { return attributes.contains(std::string(attribute)); }
  const std::string& at(std::string_view attribute) const;
};

/// A whole document: declaration, one root, matching tags, unique attributes, known entities, declared prefixes, only
/// characters that XML 1.0 allows, UTF-8.
XmlElement read_xml(std::string_view text);

struct ReadContour {
  std::vector<Vec2> points;
  bool closed = false;
};

/// Path data of m, l, h, v and z in both cases. Refuses exponents, "-0", and a number without need of its zeros.
std::vector<ReadContour> read_path_data(std::string_view data);

/// Takes back xml_exact_text()'s escapes after XML's own are resolved.
std::string exact_text(std::string_view escaped);

}  // namespace burin::test
