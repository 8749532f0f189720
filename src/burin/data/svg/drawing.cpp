#include <algorithm>
#include <utility>

#include <burin/data/svg/drawing.hpp>
#include <burin/data/svg/walker.hpp>
#include <burin/data/svg/words.hpp>

namespace burin::data {

namespace svg {

namespace {

/// The words of an element and of all within, one blank between; at most 1000 bytes.
std::string words_within(const XmlElement& element) {
  std::string all;
  for (XmlElement at = element; at && all.size() < 1000; at = at.next_within(element)) {
    const std::string text = at.text();
    const std::string_view words = trimmed(text);
    if (words.empty()) continue;
    if (!all.empty()) all += ' ';
    all += words;
  }
  return all;
}

}  // namespace

void Walker::read_style_sheets() {
  std::vector<std::string> not_understood;
  for (XmlElement at = root_; at; at = at.next_within(root_)) {
    if (at.local_name() != "style" || !is_drawing_element(at)) continue;
    sheet_.add(at.text(), not_understood);
    for (const std::string& selector : not_understood) {
      report(at, "the rule '" + selector.substr(0, 80) +
                     "' of its style sheet is not followed; only tags, .classes and "
                     "#ids are");
    }
    not_understood.clear();
  }
}

void Walker::read_about() {
  SvgAbout& about = drawing_.about;
  for (XmlElement child = root_.first_child(); child; child = child.next_sibling()) {
    if (child.local_name() == "title" && about.title.empty()) about.title = words_within(child);
    if (child.local_name() != "metadata") continue;
    for (XmlElement at = child; at; at = at.next_within(child)) {
      const std::string_view tag = at.local_name();
      if (tag == "title" && about.title.empty()) about.title = words_within(at);
      if (tag == "creator" && about.creator.empty()) about.creator = words_within(at);
      if (tag == "subject" && about.subject.empty()) about.subject = words_within(at);
      if (tag == "rights") about.licence = words_within(at);
      if (tag == "license" && about.licence.empty()) about.licence = at.attribute("rdf:resource").value_or("");
    }
  }
}

}  // namespace svg

Box2 SvgDrawing::box() const {
  Box2 box;
  for (const SvgShape& shape : shapes) {
    for (const Subpath& subpath : shape.subpaths) {
      for (const Vec2 p : subpath.points) box.add(p);
    }
  }
  return box;
}

Result<SvgDrawing> read_svg(std::string_view text, const std::string& file, double relative_tolerance) {
  const Result<XmlDocument> document = XmlDocument::parse(text, file);
  if (!document) return document.problems();
  // How large it is decides how fine its curves must be, so it is drawn coarsely first.
  constexpr double coarse_px = 0.05;
  Result<SvgDrawing> coarse = svg::Walker(*document, coarse_px).walk();
  if (!coarse) return coarse;
  const Box2 box = coarse->box();
  const double side = std::max(box.width(), box.height());
  if (!(side > 0.0)) return coarse;
  return svg::Walker(*document, relative_tolerance * side).walk();
}

}  // namespace burin::data
