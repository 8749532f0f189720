#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <cli/fitted_preset.hpp>

namespace burin::cli {

namespace {

namespace fractal = curves::fractal_interpolation;

/// "[a, b, ...]" in lines of about 120 columns.
template <class List, class Text>
std::string list_text(const List& list, Text text_of) {
  constexpr std::size_t width = 118;
  std::string text = "[";
  std::size_t line_begin = 0;
  for (const auto& item : list) {
    const std::string word = text_of(item);
    if (text.size() > 1) text += ',';
    if (text.size() + word.size() - line_begin > width) {
      text += "\n ";
      line_begin = text.size() - 1;
    } else if (text.size() > 1) {
      text += ' ';
    }
    text += word;
  }
  return text + ']';
}

/// A TOML string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
    if (c == '$') result += '$';
  }
  return result + '"';
}

std::string scaling_text(const fractal::Scaling& scaling) {
  if (scaling.c.size() == 1) return shortest_text(scaling.c[0]);
  return list_text(scaling.c, &shortest_text);
}

std::string coordinate_text(const fractal::CoordinateFit& fit) {
  const auto shapes = [&](double fractal::Shape::*parameter) {
    return list_text(fit.data.shapes, [&](const fractal::Shape& shape) { return shortest_text(shape.*parameter); });
  };
  return fmt::format("derivatives = {}\nalpha = {}\nbeta = {}\nscaling = {}\n",
                     params::ValueType<fractal::DerivativeRule>::text(fit.rule), shapes(&fractal::Shape::alpha),
                     shapes(&fractal::Shape::beta), list_text(fit.data.scalings, &scaling_text));
}

/// The level whose points are close enough for a poster.
int drawn_levels(std::size_t intervals) {
  constexpr double enough = 4000.0;
  int level = 0;
  for (auto points = static_cast<double>(intervals); points < enough; points *= static_cast<double>(intervals)) ++level;
  return level;
}

}  // namespace

std::string fitted_preset(const fractal::Comparison& comparison, fractal::Method method, std::span<const Vec2> points,
                          const FittedData& data) {
  const fractal::ContourFit& fit = comparison.fits[static_cast<std::size_t>(method)];
  const std::size_t intervals = comparison.knots.size() - 1;
  std::string text = fmt::format(
      "# Fitted by burin fit: {} intervals, RMSE {:.3g} where the larger side is 1.\n"
      "burin = 1\n"
      "about = {{ title = {}, summary = \"Fractal interpolation fitted to data.\" }}\n"
      "page = {{ size = \"30x30cm\", margin = \"30mm 30mm 38mm\" }}\n\n"
      "[knobs]\n"
      "levels = {{ default = {}, min = 0, max = 1000, doc = \"refinement levels of the fit\" }}\n\n"
      "[pens]\n"
      "data = {{ color = \"#e3b7a0\", width = \"1mm\" }}\n"
      "fit = {{ color = \"#1b2a41\", width = \"0.3mm\" }}\n"
      "knots = {{ color = \"#a3341f\", width = \"1.2mm\" }}\n\n",
      intervals, fit.rmse, quoted(data.file), drawn_levels(intervals));
  text += fmt::format(
      "[[layer]]\n"
      "name = \"data\"\n"
      "pen = \"data\"\n"
      "curve = {{ family = \"fractal-interpolation\", data = {}, over = \"chords\", closed = {}, lonlat = {}, levels = "
      "0 "
      "}}\n\n",
      quoted(data.file), data.closed, data.lonlat);
  text +=
      fmt::format("[[layer]]\nname = \"knots\"\npen = \"knots\"\ncurve = {{ like = \"fit\", plot = \"nodes\" }}\n\n");
  text += "[[layer]]\nname = \"fit\"\npen = \"fit\"\ncurve = \"fit\"\n\n";
  text += fmt::format(
      "[define.fit]\n"
      "family = \"fractal-interpolation\"\n"
      "over = \"chords\"\n"
      "closed = {}\n"
      "levels = \"$levels\"\n"
      "points = {}\n"
      "at = {}\n\n",
      data.closed,
      list_text(comparison.knots,
                [&](std::size_t k) {
                  return fmt::format("[{}, {}]", shortest_text(points[k].x), shortest_text(points[k].y));
                }),
      list_text(comparison.knots, [&](std::size_t k) { return shortest_text(comparison.t[k]); }));
  text += "[define.fit.x]\n" + coordinate_text(fit.coordinates[0]);
  text += "\n[define.fit.y]\n" + coordinate_text(fit.coordinates[1]);
  return text;
}

}  // namespace burin::cli
