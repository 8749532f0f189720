#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <burin/data/xml.hpp>

namespace burin::data::svg {

/// What SVG says of how an element is painted: values as written, those of its ancestors where it says nothing.
struct Style {
  // Inherited.
  std::string_view color = "black";
  std::string_view fill = "black";
  std::string_view fill_rule = "nonzero";
  std::string_view fill_opacity = "1";
  std::string_view stroke = "none";
  std::string_view stroke_width = "1";
  std::string_view stroke_opacity = "1";
  std::string_view linecap = "butt";
  std::string_view linejoin = "miter";
  std::string_view miterlimit = "4";
  std::string_view dasharray = "none";
  std::string_view dashoffset = "0";
  std::string_view marker = "none";
  std::string_view visibility = "visible";
  // The element's own.
  std::string_view display = "inline";
  std::string_view opacity = "1";
  std::string_view transform;
  std::string_view clip_path = "none";
  std::string_view mask = "none";
  std::string_view filter = "none";
  std::string_view vector_effect = "none";
};

/// The rules of the document's <style> elements: selectors of a tag, classes and an id, and lists of them.
class StyleSheet {
 public:
  /// Adds the rules of one <style>. Whatever is no such rule is named in `not_understood`. At most 500 rules in all.
  void add(std::string text, std::vector<std::string>& not_understood);

  /// The style of an element from that of its parent: attributes, then rules, then its `style`.
  Style style_of(const XmlElement& element, const Style& parent) const;

 private:
  struct Selector {
    std::string_view tag;
    std::string_view id;
    std::vector<std::string_view> classes;
    int weight() const;
  };
  /// What selectors ask of an element.
  struct Labels {
    std::string_view tag;
    std::string_view id;
    std::vector<std::string_view> classes;
    bool match(const Selector& selector) const;
  };
  struct Declaration {
    std::string_view Style::*member = nullptr;
    std::string_view value;
  };
  struct Rule {
    Selector selector;
    std::vector<Declaration> declarations;  ///< one for each property at most
  };
  static std::vector<Declaration> parse_declarations(std::string_view text);
  static bool parse_selector(std::string_view text, Selector& selector);
  void add_rule(std::string_view selectors, std::string_view declarations, std::vector<std::string>& not_understood);

  std::vector<std::shared_ptr<const std::string>> texts_;
  std::vector<Rule> rules_;  ///< by weight, then as they come
};

}  // namespace burin::data::svg
