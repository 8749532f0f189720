#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <burin/base/math.hpp>
#include <burin/data/svg/transform.hpp>
#include <burin/data/svg/words.hpp>

namespace burin::data::svg {

namespace {

/// A function of a transform with its arguments; nothing when it is none.
std::optional<Affine2> function_map(std::string_view name, const std::vector<double>& a) {
  const std::size_t n = a.size();
  if (name == "matrix" && n == 6) return Affine2{a[0], a[1], a[2], a[3], a[4], a[5]};
  if (name == "translate" && (n == 1 || n == 2)) return translation({a[0], n == 2 ? a[1] : 0.0});
  if (name == "scale" && (n == 1 || n == 2)) return scaling(a[0], n == 2 ? a[1] : a[0]);
  // With y down this turns clockwise, as SVG says.
  if (name == "rotate" && n == 1) return rotation_degrees(a[0]);
  if (name == "rotate" && n == 3) {
    return translation({a[1], a[2]}) * rotation_degrees(a[0]) * translation({-a[1], -a[2]});
  }
  const bool skew = n == 1 && math::cos_degrees(a[0]) != 0.0;
  const double slope = skew ? math::sin_degrees(a[0]) / math::cos_degrees(a[0]) : 0.0;
  if (name == "skewX" && skew) return Affine2{1.0, 0.0, slope, 1.0, 0.0, 0.0};
  if (name == "skewY" && skew) return Affine2{1.0, slope, 0.0, 1.0, 0.0, 0.0};
  return std::nullopt;
}

/// The arguments of a transform as CSS also writes them: "10px, 45deg".
std::optional<std::vector<double>> arguments_of(std::string_view text) {
  std::string plain(text);
  for (const std::string_view unit : {"px", "deg"}) {
    for (std::size_t at = plain.find(unit); at != std::string::npos; at = plain.find(unit, at)) {
      plain.erase(at, unit.size());
    }
  }
  return numbers(plain);
}

/// Where a box lies in a room of its own size or larger: 0, a half, or 1 of what is left.
double alignment(std::string_view word, std::string_view middle, std::string_view end) {
  if (word.find(end) != std::string_view::npos) return 1.0;
  return word.find(middle) != std::string_view::npos ? 0.5 : 0.0;
}

}  // namespace

std::optional<Affine2> parse_transform(std::string_view text) {
  Affine2 map;
  text = trimmed(text);
  if (text == "none") return map;
  while (!text.empty()) {
    if (text.front() == ',') {
      text = trimmed(text.substr(1));
      continue;
    }
    if (text.find(')') == std::string_view::npos) return std::nullopt;
    const std::string_view name = take_until(text, '(');
    const std::optional<std::vector<double>> arguments = arguments_of(take_until(text, ')'));
    const std::optional<Affine2> next = arguments ? function_map(name, *arguments) : std::nullopt;
    if (!next) return std::nullopt;
    map = map * *next;
    text = trimmed(text);
  }
  return map;
}

double largest_stretch(const Affine2& map) {
  const double sum = map.a * map.a + map.b * map.b + map.c * map.c + map.d * map.d;
  const double det = map.determinant();
  return std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * det * det))));
}

std::optional<Affine2> viewport_from_view_box(const XmlElement& element, Vec2 viewport_px) {
  const std::optional<std::string_view> written = element.attribute("viewBox");
  if (!written) return Affine2{};
  const std::optional<std::vector<double>> box = numbers(*written);
  if (!box || box->size() != 4 || !((*box)[2] > 0.0) || !((*box)[3] > 0.0)) return std::nullopt;
  const Vec2 low{(*box)[0], (*box)[1]};
  const Vec2 size{(*box)[2], (*box)[3]};
  const Vec2 fit{viewport_px.x / size.x, viewport_px.y / size.y};
  const std::string_view ratio = trimmed(element.attribute("preserveAspectRatio").value_or("xMidYMid meet"));
  if (ratio.substr(0, 4) == "none") return scaling(fit.x, fit.y) * translation(-low);
  const bool slice = ratio.find("slice") != std::string_view::npos;
  const double scale = slice ? std::max(fit.x, fit.y) : std::min(fit.x, fit.y);
  const Vec2 left = viewport_px - scale * size;
  const Vec2 shift{alignment(ratio, "xMid", "xMax") * left.x, alignment(ratio, "YMid", "YMax") * left.y};
  return translation(shift) * scaling(scale, scale) * translation(-low);
}

}  // namespace burin::data::svg
