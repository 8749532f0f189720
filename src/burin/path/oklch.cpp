#include <algorithm>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/path/oklch.hpp>

namespace burin {

namespace {

struct Oklch {
  double lightness;
  double chroma;
  double hue;  ///< degrees
};

double linear_from_srgb(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : math::pow((c + 0.055) / 1.055, 2.4);
}

std::uint8_t srgb_from_linear(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * math::pow(c, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
}

Oklch oklch_from(Colour colour) {
  const double r = linear_from_srgb(colour.red);
  const double g = linear_from_srgb(colour.green);
  const double b = linear_from_srgb(colour.blue);
  const double l = math::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = math::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = math::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  const double green_red = 1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s;
  const double blue_yellow = 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s;
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, math::hypot(green_red, blue_yellow),
          math::atan2_degrees(blue_yellow, green_red)};
}

Colour colour_from(const Oklch& colour) {
  const double green_red = colour.chroma * math::cos_degrees(colour.hue);
  const double blue_yellow = colour.chroma * math::sin_degrees(colour.hue);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(colour.lightness + 0.3963377774 * green_red + 0.2158037573 * blue_yellow);
  const double m = cube(colour.lightness - 0.1055613458 * green_red - 0.0638541728 * blue_yellow);
  const double s = cube(colour.lightness - 0.0894841775 * green_red - 1.2914855480 * blue_yellow);
  return {srgb_from_linear(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          srgb_from_linear(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          srgb_from_linear(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Colour mix_colours(Colour from, Colour to, double share) {
  if (share <= 0.0) return from;
  if (share >= 1.0) return to;
  constexpr double grey = 0.004;  // chroma below which a hue is but rounding
  Oklch a = oklch_from(from);
  Oklch b = oklch_from(to);
  if (a.chroma < grey) a.hue = b.hue;
  if (b.chroma < grey) b.hue = a.hue;
  const double turn = b.hue - a.hue;
  const double short_turn = turn - 360.0 * std::round(turn / 360.0);
  const auto between = [share](double x, double y) { return x + share * (y - x); };
  return colour_from({between(a.lightness, b.lightness), between(a.chroma, b.chroma), a.hue + share * short_turn});
}

}  // namespace burin
