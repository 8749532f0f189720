#include <algorithm>
#include <array>
#include <utility>

#include <burin/data/svg/shapes.hpp>
#include <burin/data/svg/transform.hpp>
#include <burin/data/svg/walker.hpp>
#include <burin/data/svg/words.hpp>

namespace burin::data::svg {

namespace {

constexpr std::size_t max_elements = 100'000;
constexpr std::size_t max_points = std::size_t{1} << 20U;
constexpr std::size_t max_reports = 50;
constexpr int max_depth = 200;
constexpr double max_coordinate = 1e12;

/// Elements that only describe, or are drawn by way of others.
constexpr std::array<std::string_view, 21> silent_tags{
    "defs",           "symbol",         "title",   "desc",   "metadata", "style",         "script",
    "linearGradient", "radialGradient", "stop",    "marker", "pattern",  "clipPath",      "mask",
    "filter",         "view",           "animate", "set",    "cursor",   "animateMotion", "animateTransform"};

template <class Range, class T>
bool holds(const Range& range, const T& item) {
  return std::find(range.begin(), range.end(), item) != range.end();
}

bool is_far(Vec2 p) {
  return !(std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate);
}

/// A name that an entity stands for somewhere in an attribute's value: "&name;".
bool has_entity(std::string_view value) {
  const std::size_t at = value.find('&');
  return at != std::string_view::npos && value.find(';', at) != std::string_view::npos;
}

/// A long one counts as several, for `use` may have it read again and again.
std::size_t weight_of(const XmlElement& element) {
  constexpr std::size_t usual_bytes = 256;
  return 1 + element.attribute_bytes() / usual_bytes;
}

bool is_anchor(const XmlElement& element) {
  return element.attribute("inkscape:label") == "anchor" || element.attribute("id") == "anchor";
}

/// The attribute that holds an entity, of those that are looked at; empty: none does.
std::string_view attribute_with_entity(const XmlElement& element) {
  static constexpr std::array<std::string_view, 14> names{
      "d", "points", "style", "transform", "fill", "stroke", "x", "y", "width", "height", "r", "cx", "cy", "class"};
  const auto found = std::find_if(names.begin(), names.end(), [&](std::string_view name) {
    return has_entity(element.attribute(name).value_or(""));
  });
  return found == names.end() ? std::string_view() : *found;
}

Affine2 moved(const Affine2& map, double x, double y) {
  return map * translation({x, y});
}

}  // namespace

Walker::Walker(const XmlDocument& document, double tolerance_px)
    : document_(document), root_(document.root()), tolerance_px_(tolerance_px) {}

Result<SvgDrawing> Walker::walk() {
  if (root_.local_name() != "svg") {
    fail(root_, "the file is no SVG: its first element is <" + std::string(root_.name()) + ">");
    return *failure_;
  }
  read_style_sheets();
  read_about();
  const auto size_of = [&](std::string_view name) -> std::optional<double> {
    const std::string_view text = trimmed(root_.attribute(name).value_or("auto"));
    if (text == "auto" || text.find('%') != std::string_view::npos) return std::nullopt;
    const std::optional<double> px = length_px(text, 0.0);
    if (!px || !(*px > 0.0)) fail(root_, "its '" + std::string(name) + "' is no length above 0");
    return px;
  };
  std::optional<double> width = size_of("width");
  std::optional<double> height = size_of("height");
  const std::optional<std::vector<double>> box = numbers(root_.attribute("viewBox").value_or(""));
  const bool has_box = box && box->size() == 4 && (*box)[2] > 0.0 && (*box)[3] > 0.0;
  const double ratio = has_box ? (*box)[3] / (*box)[2] : 1.0;
  if (!width) width = height ? *height / ratio : has_box ? (*box)[2] : 100.0;
  if (!height) height = *width * ratio;
  drawing_.size_px = {*width, *height};

  Context context;
  if (enter(root_, {}, {.viewport = drawing_.size_px}, context)) visit_viewport(root_, context, {});
  if (failure_) return *failure_;
  return std::move(drawing_);
}

void Walker::fail(const XmlElement& element, std::string message, Trouble trouble) {
  if (!failure_) failure_ = Problem{document_.where(element), std::move(message), trouble};
}

void Walker::report(const XmlElement& element, const std::string& message) {
  if (drawing_.not_drawn.size() >= max_reports || !reported_.emplace(element.offset(), message).second) return;
  std::string name = '<' + std::string(element.name());
  if (const std::optional<std::string_view> id = element.attribute("id")) name += " id=\"" + std::string(*id) + '"';
  drawing_.not_drawn.push_back({document_.where(element), name + ">: " + message});
}

/// Elements of other names than SVG's hold what programs note for themselves.
bool Walker::is_drawing_element(const XmlElement& element) const {
  const std::string_view name = element.name();
  const std::string_view local = element.local_name();
  const bool prefixed = name.size() != local.size();
  if (!prefixed) return true;
  const std::string_view prefix = name.substr(0, name.size() - local.size());
  const std::string_view root_name = root_.name();
  return prefix == "svg:" || prefix == root_name.substr(0, root_name.size() - root_.local_name().size());
}

/// The context inside an element; false when nothing of it can be drawn.
bool Walker::enter(const XmlElement& element, const Style& style, const Context& parent, Context& context) {
  context = parent;
  context.style = sheet_.style_of(element, style);
  context.depth = parent.depth + 1;
  context.opacity = parent.opacity * std::clamp(share(context.style.opacity, 1.0), 0.0, 1.0);
  context.hidden = parent.hidden || context.style.display == "none" || context.opacity == 0.0;
  const std::optional<Affine2> map = parse_transform(context.style.transform);
  if (!map) report(element, "its transform '" + std::string(context.style.transform) + "' is none of SVG's");
  context.px_from_user = parent.px_from_user * map.value_or(Affine2{});
  return map.has_value();
}

void Walker::visit(const XmlElement& element, const Context& parent) {
  if (failure_) return;
  const std::string_view tag = element.local_name();
  elements_ += weight_of(element);
  if (elements_ > max_elements) {
    return fail(element, "it has more than 100000 elements to draw; simplify it", Trouble::limit);
  }
  if (!is_drawing_element(element) || holds(silent_tags, tag)) return;
  if (parent.depth >= max_depth) {
    return fail(element, "more than 200 groups stand one in another; ungroup them", Trouble::limit);
  }
  if (const std::string_view name = attribute_with_entity(element); !name.empty()) {
    return report(element, "its '" + std::string(name) +
                               "' holds an entity (&...;), which is not looked up; save the file as plain SVG");
  }
  Context context;
  if (!enter(element, parent.style, parent, context)) return;
  if (!drawing_.anchor && is_anchor(element)) return note_anchor(element, context);
  const std::size_t first_shape = drawing_.shapes.size();
  visit_content(element, context);
  if (!context.hidden && !failure_) check_effects(element, context, first_shape);
}

void Walker::visit_content(const XmlElement& element, const Context& context) {
  const std::string_view tag = element.local_name();
  if (tag == "g" || tag == "a") return visit_children(element, context);
  if (tag == "switch") return visit_switch(element, context);
  if (tag == "svg") return visit_viewport(element, context, element);
  if (context.hidden) return;
  if (tag == "use") return visit_use(element, context);
  if (is_shape(tag)) return draw(element, context);
  if (tag == "text" || tag == "flowRoot") {
    return report(element, "text is not drawn; turn it into paths (in Inkscape: Path > Object to Path)");
  }
  if (tag == "image") return report(element, "pictures are not drawn; trace them, or remove them");
  report(element, "there is no way to draw such an element");
}

void Walker::visit_children(const XmlElement& element, const Context& context) {
  for (XmlElement child = element.first_child(); child && !failure_; child = child.next_sibling()) {
    visit(child, context);
  }
}

/// The first child that needs no extension and is not for another language.
void Walker::visit_switch(const XmlElement& element, const Context& context) {
  for (XmlElement child = element.first_child(); child; child = child.next_sibling()) {
    const std::string_view language = child.attribute("systemLanguage").value_or("en");
    if (!is_drawing_element(child) || child.attribute("requiredExtensions") || language.substr(0, 2) != "en") continue;
    return visit(child, context);
  }
}

/// An element that may set up coordinates of its own: the root, a nested <svg>, or a <symbol>. `sized_by` says where it
/// lies; nothing for the root, whose size is known.
void Walker::visit_viewport(const XmlElement& element, Context context, const XmlElement& sized_by) {
  Vec2 size = context.viewport;
  if (sized_by) {
    const auto length = [&](std::string_view name, double whole, double otherwise) {
      const std::optional<std::string_view> own = sized_by.attribute(name);
      const std::string_view text = own ? *own : element.attribute(name).value_or("auto");
      return length_px(text, whole).value_or(otherwise);
    };
    if (element == sized_by) {
      context.px_from_user =
          moved(context.px_from_user, length("x", context.viewport.x, 0.0), length("y", context.viewport.y, 0.0));
    }
    size = {length("width", context.viewport.x, context.viewport.x),
            length("height", context.viewport.y, context.viewport.y)};
  }
  const std::optional<Affine2> viewport_from_user = viewport_from_view_box(element, size);
  if (!viewport_from_user || !(viewport_from_user->determinant() > 0.0)) {
    return report(element, "its viewBox is not 'x y width height' with a width and a height above 0");
  }
  const Vec2 box_size = inverse(*viewport_from_user).linear(size);
  context.px_from_user = context.px_from_user * *viewport_from_user;
  context.viewport = box_size;
  visit_children(element, context);
}

void Walker::visit_use(const XmlElement& element, const Context& parent) {
  const XmlElement target = referred_to(element);
  if (!target) return;
  bool inside = false;
  for (XmlElement up = element; up; up = up.parent()) inside = inside || up == target;
  if (inside || holds(used_, target)) {
    return fail(element, "this <use> draws itself: '" + std::string(target.attribute("id").value_or("")) +
                             "' leads back to it; break the circle");
  }
  const auto shift = [&](std::string_view name, double whole) {
    return length_px(element.attribute(name).value_or("0"), whole).value_or(0.0);
  };
  Context context = parent;
  context.px_from_user = moved(parent.px_from_user, shift("x", parent.viewport.x), shift("y", parent.viewport.y));
  used_.push_back(target);
  const std::string_view tag = target.local_name();
  if (tag == "symbol" || tag == "svg") {
    Context inner;
    elements_ += weight_of(target);
    if (elements_ <= max_elements && enter(target, context.style, context, inner)) {
      visit_viewport(target, inner, element);
    }
  } else {
    visit(target, context);
  }
  used_.pop_back();
}

/// The element that `href` names; reports and gives none when there is none in this file.
XmlElement Walker::referred_to(const XmlElement& element) {
  std::optional<std::string_view> href = element.attribute("href");
  if (!href) href = element.attribute("xlink:href");
  if (!href || href->empty()) {
    report(element, "it refers to nothing: its href is missing");
  } else if (href->front() != '#') {
    report(element, "it refers to another file, '" + std::string(href->substr(0, 80)) + "'; paste that into this one");
  } else if (const XmlElement target = with_id(href->substr(1))) {
    return target;
  } else {
    report(element, "no element has the id '" + std::string(href->substr(1, 80)) + "'");
  }
  return {};
}

XmlElement Walker::with_id(std::string_view id) {
  if (!by_id_) {
    by_id_.emplace();
    for (XmlElement at = root_; at; at = at.next_within(root_)) {
      if (const std::optional<std::string_view> own = at.attribute("id")) by_id_->emplace(*own, at);
    }
  }
  const auto found = by_id_->find(id);
  return found == by_id_->end() ? XmlElement() : found->second;
}

std::vector<Subpath> Walker::outline_px(const XmlElement& element, const Context& context) {
  const double stretch = largest_stretch(context.px_from_user);
  const double tolerance = stretch > 0.0 ? tolerance_px_ / stretch : tolerance_px_;
  Result<std::vector<Subpath>> outline = shape_outline(element, context.viewport, tolerance);
  if (!outline) {
    const Problem& problem = outline.problems().front();
    if (problem.trouble == Trouble::limit) fail(element, problem.message, problem.trouble);
    report(element, problem.message);
    return {};
  }
  for (Subpath& subpath : *outline) {
    points_ += subpath.points.size();
    for (Vec2& p : subpath.points) {
      p = context.px_from_user(p);
      if (is_far(p)) {
        fail(element, "it leads outside [-1e12, 1e12]; scale it down");
        return {};
      }
    }
  }
  if (points_ > max_points) {
    fail(element, "the curves need more than 1048576 points; simplify the drawing", Trouble::limit);
    return {};
  }
  return *std::move(outline);
}

void Walker::draw(const XmlElement& element, const Context& context) {
  if (context.style.visibility != "visible") return;
  SvgShape shape{{}, fill_of(element, context), stroke_of(element, context)};
  if (!shape.fill && !shape.stroke) return;
  shape.subpaths = outline_px(element, context);
  if (!shape.subpaths.empty()) drawing_.shapes.push_back(std::move(shape));
}

/// A line's start with its direction, or the middle of whatever it is.
void Walker::note_anchor(const XmlElement& element, const Context& context) {
  Box2 box;
  std::vector<Subpath> outline;
  if (is_shape(element.local_name())) outline = outline_px(element, context);
  for (const Subpath& subpath : outline) {
    for (const Vec2 p : subpath.points) box.add(p);
  }
  if (box.empty()) return report(element, "the anchor has no place; make it a circle, a rectangle, a line or a path");
  const bool line = outline.size() == 1 && outline.front().points.size() == 2 && !outline.front().closed;
  const Vec2 start = outline.front().points.front();
  const Vec2 along = outline.front().points.back() - start;
  if (line && length_squared(along) > 0.0) {
    drawing_.anchor = SvgAnchor{start, along};
  } else {
    drawing_.anchor = SvgAnchor{box.center(), std::nullopt};
  }
}

}  // namespace burin::data::svg
