#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <burin/data/flatten.hpp>
#include <burin/data/svg/shapes.hpp>
#include <burin/data/svg/words.hpp>
#include <burin/geom/box2.hpp>

namespace burin::data::svg {

namespace {

using Outline = std::vector<Subpath>;

/// Lengths of one element, percentages and all.
class Lengths {
 public:
  Lengths(const XmlElement& element, Vec2 viewport_px) : element_(element), viewport_px_(viewport_px) {}

  double x(std::string_view name) { return read(name, viewport_px_.x).value_or(0.0); }
  double y(std::string_view name) { return read(name, viewport_px_.y).value_or(0.0); }
  /// A length without a direction, a radius; nothing when it is not written, or "auto".
  std::optional<double> any(std::string_view name) { return read(name, length(viewport_px_) / std::sqrt(2.0)); }

  /// What is wrong with those read so far.
  const std::string& fault() const { return fault_; }

 private:
  std::optional<double> read(std::string_view name, double whole) {
    const std::optional<std::string_view> text = element_.attribute(name);
    if (!text || *text == "auto") return std::nullopt;
    const std::optional<double> px = length_px(*text, whole);
    if (!px && fault_.empty()) {
      fault_ = "its '" + std::string(name) + "' is no length between -1e12 and 1e12";
    }
    return px;
  }

  XmlElement element_;
  Vec2 viewport_px_;
  std::string fault_;
};

/// A rectangle with rounded corners, or an ellipse when they meet: clockwise on the page, from the top edge's left end,
/// as SVG draws it.
Subpath rounded_box(const Box2& box, Vec2 radii, double tolerance) {
  Subpath outline{{}, true};
  const EllipticArc quarter{radii, 0.0, false, true};
  const std::array<Vec2, 4> corners{{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}};
  const std::array<Vec2, 4> along{{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}};
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t next = (side + 1) % 4;
    const Vec2 ahead = along[side];
    const Vec2 after = along[next];
    const Vec2 from = corners[side] + Vec2{ahead.x * radii.x, ahead.y * radii.y};
    const Vec2 to = corners[next] - Vec2{ahead.x * radii.x, ahead.y * radii.y};
    if (outline.points.empty() || outline.points.back() != from) outline.points.push_back(from);
    if (outline.points.back() != to) outline.points.push_back(to);
    flatten_arc(to, quarter, corners[next] + Vec2{after.x * radii.x, after.y * radii.y}, tolerance, outline.points);
  }
  if (outline.points.size() > 1 && outline.points.back() == outline.points.front()) outline.points.pop_back();
  return outline;
}

Outline rectangle(Lengths& lengths, double tolerance) {
  const Vec2 low{lengths.x("x"), lengths.y("y")};
  const Vec2 size{lengths.x("width"), lengths.y("height")};
  std::optional<double> rx = lengths.any("rx");
  std::optional<double> ry = lengths.any("ry");
  if (!(size.x > 0.0) || !(size.y > 0.0)) return {};
  const Box2 box{low, low + size};
  if (!rx) rx = ry;
  if (!ry) ry = rx;
  const Vec2 radii{std::min(rx.value_or(0.0), 0.5 * size.x), std::min(ry.value_or(0.0), 0.5 * size.y)};
  if (!(radii.x > 0.0) || !(radii.y > 0.0)) {
    return {{{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, true}};
  }
  return {rounded_box(box, radii, tolerance)};
}

Outline ellipse(Vec2 center, Vec2 radii, double tolerance) {
  if (!(radii.x > 0.0) || !(radii.y > 0.0)) return {};
  return {rounded_box({center - radii, center + radii}, radii, tolerance)};
}

Result<Outline> polyline(const XmlElement& element, bool closed) {
  std::string_view rest = trimmed(element.attribute("points").value_or(""));
  Subpath line{{}, closed};
  while (!rest.empty()) {
    const std::optional<double> x = take_number(rest);
    const std::optional<double> y = x ? take_number(rest) : std::nullopt;
    if (!y) return Problem{{}, "its 'points' are no list of x,y pairs between -1e12 and 1e12"};
    line.points.push_back({*x, *y});
  }
  if (line.points.size() < 2) return Outline{};
  if (closed && line.points.front() == line.points.back()) line.points.pop_back();
  return Outline{std::move(line)};
}

}  // namespace

bool is_shape(std::string_view tag) {
  constexpr std::array<std::string_view, 7> tags{"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"};
  return std::find(tags.begin(), tags.end(), tag) != tags.end();
}

Result<std::vector<Subpath>> shape_outline(const XmlElement& element, Vec2 viewport_px, double tolerance) {
  const std::string_view tag = element.local_name();
  if (tag == "path") return parse_svg_path(element.attribute("d").value_or(""), tolerance, {});
  if (tag == "polyline" || tag == "polygon") return polyline(element, tag == "polygon");
  Lengths lengths(element, viewport_px);
  Outline outline;
  if (tag == "rect") {
    outline = rectangle(lengths, tolerance);
  } else if (tag == "line") {
    outline = {{{{lengths.x("x1"), lengths.y("y1")}, {lengths.x("x2"), lengths.y("y2")}}, false}};
  } else {
    const Vec2 center{lengths.x("cx"), lengths.y("cy")};
    const double radius = lengths.any("r").value_or(0.0);
    const bool circle = tag == "circle";
    const double rx = circle ? radius : lengths.any("rx").value_or(lengths.any("ry").value_or(0.0));
    const double ry = circle ? radius : lengths.any("ry").value_or(rx);
    outline = ellipse(center, {rx, ry}, tolerance);
  }
  if (!lengths.fault().empty()) return Problem{{}, lengths.fault()};
  return outline;
}

}  // namespace burin::data::svg
