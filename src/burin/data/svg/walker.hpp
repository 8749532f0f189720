#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <burin/data/svg/drawing.hpp>
#include <burin/data/svg/style.hpp>
#include <burin/data/xml.hpp>
#include <burin/geom/affine2.hpp>

namespace burin::data::svg {

/// Goes through a document and collects what can be seen of it.
class Walker {
 public:
  /// Curves keep to `tolerance_px`.
  Walker(const XmlDocument& document, double tolerance_px);

  /// The whole document.
  Result<SvgDrawing> walk();

 private:
  /// Where an element stands.
  struct Context {
    Style style{};
    Affine2 px_from_user{};
    Vec2 viewport{};  ///< in user units: what percentages are of
    double opacity = 1.0;
    bool hidden = false;  ///< nothing is drawn, only the anchor is looked for
    int depth = 0;
  };

  void visit(const XmlElement& element, const Context& parent);
  void visit_children(const XmlElement& element, const Context& context);
  void visit_content(const XmlElement& element, const Context& context);
  void visit_switch(const XmlElement& element, const Context& context);
  void visit_use(const XmlElement& element, const Context& context);
  void visit_viewport(const XmlElement& element, Context context, const XmlElement& sized_by);
  void draw(const XmlElement& element, const Context& context);
  void note_anchor(const XmlElement& element, const Context& context);

  bool enter(const XmlElement& element, const Style& style, const Context& parent, Context& context);
  void check_effects(const XmlElement& element, const Context& context, std::size_t first_shape);
  bool clips_nothing(std::string_view clip_path, const Context& context, std::size_t first_shape);
  std::vector<Subpath> outline_px(const XmlElement& element, const Context& context);
  std::optional<SvgFill> fill_of(const XmlElement& element, const Context& context);
  std::optional<SvgStroke> stroke_of(const XmlElement& element, const Context& context);
  /// A paint's colour; nothing for none. What is no colour is reported and drawn in black.
  std::optional<std::string> colour_of(const XmlElement& element, std::string_view paint, const Style& style);

  XmlElement with_id(std::string_view id);
  XmlElement referred_to(const XmlElement& element);
  void read_style_sheets();
  void read_about();
  bool is_drawing_element(const XmlElement& element) const;
  void report(const XmlElement& element, const std::string& message);
  void fail(const XmlElement& element, std::string message, Trouble trouble = Trouble::input);

  const XmlDocument& document_;
  XmlElement root_;
  double tolerance_px_;
  StyleSheet sheet_;
  SvgDrawing drawing_;
  std::optional<Problem> failure_;
  std::optional<std::map<std::string_view, XmlElement>> by_id_;
  std::vector<XmlElement> used_;                            ///< what is being drawn by way of a <use>
  std::set<std::pair<std::size_t, std::string>> reported_;  ///< by offset and message
  std::size_t elements_ = 0;
  std::size_t points_ = 0;
};

}  // namespace burin::data::svg
