#include <algorithm>
#include <array>

#include <burin/data/svg/shapes.hpp>
#include <burin/data/svg/transform.hpp>
#include <burin/data/svg/walker.hpp>
#include <burin/data/svg/words.hpp>

namespace burin::data::svg {

namespace {

/// The id in "url(#id)", with or without quotes; nothing when it is none of this file.
std::optional<std::string_view> url_id(std::string_view text) {
  if (text.substr(0, 4) != "url(") return std::nullopt;
  text = text.substr(4, text.find(')') == std::string_view::npos ? text.npos : text.find(')') - 4);
  text = trimmed(text);
  for (const char quote : {'"', '\''}) {
    if (text.size() > 1 && text.front() == quote && text.back() == quote) text = text.substr(1, text.size() - 2);
  }
  if (text.empty() || text.front() != '#') return std::nullopt;
  return text.substr(1);
}

double opacity_of(std::string_view text) {
  return std::clamp(share(text, 1.0), 0.0, 1.0);
}

Box2 box_of(const SvgShape& shape) {
  Box2 box;
  for (const Subpath& subpath : shape.subpaths) {
    for (const Vec2 p : subpath.points) box.add(p);
  }
  return box.grown(shape.stroke ? 0.5 * shape.stroke->width : 0.0);
}

/// On and off in turn; empty for a full line. An odd number of lengths is written twice, as SVG says.
std::vector<double> dashes_of(std::string_view text, double whole, double scale) {
  std::vector<double> dashes;
  double total = 0.0;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(", \t\n\r\f"), text.size());
    if (end > 0) {
      const std::optional<double> dash = length_px(text.substr(0, end), whole);
      if (!dash || *dash < 0.0) return {};
      dashes.push_back(*dash * scale);
      total += dashes.back();
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!(total > 0.0)) return {};
  if (dashes.size() % 2 == 1) dashes.insert(dashes.end(), dashes.begin(), dashes.end());
  return dashes;
}

}  // namespace

std::optional<std::string> Walker::colour_of(const XmlElement& element, std::string_view paint, const Style& style) {
  if (paint == "none" || paint == "transparent") return std::nullopt;
  if (paint == "currentColor" || paint == "currentcolor") paint = style.color;
  if (paint.substr(0, 4) != "url(") return std::string(paint);
  const std::size_t end = paint.find(')');
  const std::string_view otherwise = end == std::string_view::npos ? "" : trimmed(paint.substr(end + 1));
  const std::optional<std::string_view> id = url_id(paint);
  const XmlElement server = id ? with_id(*id) : XmlElement();
  if (!server) return otherwise == "none" || otherwise.empty() ? std::nullopt : std::optional(std::string(otherwise));
  report(element,
         "it is painted with a <" + std::string(server.name()) + ">, and pens have one colour; give it a flat colour");
  return "black";
}

std::optional<SvgFill> Walker::fill_of(const XmlElement& element, const Context& context) {
  const Style& style = context.style;
  const std::optional<std::string> colour = colour_of(element, style.fill, style);
  const double opacity = context.opacity * opacity_of(style.fill_opacity);
  if (!colour || opacity == 0.0 || element.local_name() == "line") return std::nullopt;
  return SvgFill{*colour, opacity, style.fill_rule == "evenodd"};
}

std::optional<SvgStroke> Walker::stroke_of(const XmlElement& element, const Context& context) {
  const Style& style = context.style;
  const std::optional<std::string> colour = colour_of(element, style.stroke, style);
  const double opacity = context.opacity * opacity_of(style.stroke_opacity);
  if (!colour || opacity == 0.0) return std::nullopt;
  const double diagonal = length(context.viewport) / std::sqrt(2.0);
  const double scale = style.vector_effect == "non-scaling-stroke" ? 1.0 : context.px_from_user.scale();
  const double width = scale * length_px(style.stroke_width, diagonal).value_or(1.0);
  if (!(width > 0.0)) return std::nullopt;
  if (style.marker != "none") report(element, "markers on lines are not drawn; turn the stroke into paths");
  return SvgStroke{*colour,
                   opacity,
                   width,
                   std::string(style.linecap),
                   std::string(style.linejoin),
                   share(style.miterlimit, 4.0),
                   dashes_of(style.dasharray, diagonal, scale),
                   scale * length_px(style.dashoffset, diagonal).value_or(0.0)};
}

/// Clip paths, masks and filters that change what the element's shapes look like.
void Walker::check_effects(const XmlElement& element, const Context& context, std::size_t first_shape) {
  const Style& style = context.style;
  if (first_shape == drawing_.shapes.size()) return;
  if (style.clip_path != "none" && !clips_nothing(style.clip_path, context, first_shape)) {
    report(element,
           "it is cut off by a clip path, which is not followed; cut the shapes themselves (in Inkscape: "
           "Path > Intersection)");
  }
  if (style.mask != "none") report(element, "it is hidden in part by a mask, which is not followed; remove the mask");
  if (style.filter != "none") report(element, "it has a filter, which is not followed; remove the filter");
}

/// Whether a clip path is one rectangle around everything drawn since `first_shape`, as many programs write.
bool Walker::clips_nothing(std::string_view clip_path, const Context& context, std::size_t first_shape) {
  const std::optional<std::string_view> id = url_id(clip_path);
  const XmlElement clip = id ? with_id(*id) : XmlElement();
  if (!clip) return true;  // a reference to nothing clips nothing
  const XmlElement shape = clip.first_child();
  const bool plain = shape && !shape.next_sibling() && is_shape(shape.local_name()) &&
                     !clip.attribute("clipPathUnits") && !clip.attribute("transform") && !shape.attribute("transform");
  if (!plain) return false;
  const Result<std::vector<Subpath>> outline = shape_outline(shape, context.viewport, tolerance_px_);
  if (!outline || outline->size() != 1 || outline->front().points.size() < 4 || outline->front().points.size() > 5) {
    return false;
  }
  Box2 clip_px;
  for (const Vec2 p : outline->front().points) clip_px.add(context.px_from_user(p));
  for (const Vec2 p : outline->front().points) {
    const Vec2 q = context.px_from_user(p);
    const double slack = 1e-6 * (clip_px.width() + clip_px.height());
    const bool corner = std::min(q.x - clip_px.low.x, clip_px.high.x - q.x) <= slack &&
                        std::min(q.y - clip_px.low.y, clip_px.high.y - q.y) <= slack;
    if (!corner) return false;
  }
  const Box2 room = clip_px.grown(1e-3 * (clip_px.width() + clip_px.height()));
  return std::all_of(drawing_.shapes.begin() + static_cast<std::ptrdiff_t>(first_shape), drawing_.shapes.end(),
                     [&](const SvgShape& drawn) {
                       const Box2 box = box_of(drawn);
                       return room.contains(box.low) && room.contains(box.high);
                     });
}

}  // namespace burin::data::svg
