#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/output/svg_uses.hpp>

namespace burin::output {

namespace {

constexpr double farthest_mm = 1e5;
constexpr double nm_per_mm = 1e6;

bool is_drawn_as(const Figure& figure, Paint paint) {
  const std::vector<Recording::Path>& paths = figure.drawing().paths();
  return !paths.empty() &&
         std::ranges::all_of(paths, [&](const Recording::Path& path) { return path.head.paint == paint; });
}

/// Turns and mirrors are told to so many decimals that a figure's farthest point is right.
std::string use_text(std::size_t number, const Affine2& at, double scale, int decimals) {
  constexpr int turn_decimals = 7;
  const auto turn = [&](double value) { return fixed_text(value / scale, turn_decimals); };
  std::string transform;
  if (at.a == scale && at.d == scale && at.b == 0.0 && at.c == 0.0) {
    transform = "translate(";
  } else {
    transform = fmt::format("matrix({} {} {} {} ", turn(at.a), turn(at.b), turn(at.c), turn(at.d));
  }
  return fmt::format("<use xlink:href=\"#figure{}\" transform=\"{}{} {})\"/>\n", number, transform,
                     fixed_text(at.e, decimals), fixed_text(at.f, decimals));
}

}  // namespace

std::string SvgUses::show(const Figure& figure, const Affine2& at, Paint layer_paint) {
  const double scale = at.scale();
  const double reach = std::max({std::abs(figure.bounds().low.x), std::abs(figure.bounds().low.y),
                                 std::abs(figure.bounds().high.x), std::abs(figure.bounds().high.y)});
  const bool is_near = scale > 0.0 && scale * (1.0 + reach) < farthest_mm && std::abs(at.e) < farthest_mm &&
                       std::abs(at.f) < farthest_mm;
  if (uses_ == most_uses || !is_near || !is_similarity(at) || !is_drawn_as(figure, layer_paint)) return {};
  const std::int64_t size_nm = std::llround(nm_per_mm * scale);
  const auto known = std::ranges::find_if(definitions_, [&](const Definition& definition) {
    return definition.size_nm == size_nm && definition.figure.looks_like(figure);
  });
  const auto number = static_cast<std::size_t>(known - definitions_.begin()) + 1;
  std::string text;
  if (known == definitions_.end()) {
    if (definitions_.size() == most_definitions) return {};
    text = define(figure, scale, number);
    definitions_.push_back({figure, size_nm});
  }
  ++uses_;
  return text + use_text(number, at, scale, data_.grid().decimals());
}

std::string SvgUses::define(const Figure& figure, double scale, std::size_t number) {
  const Recording& drawing = figure.drawing();
  std::string text = fmt::format("<defs><g id=\"figure{}\">", number);
  for (const Recording::Path& path : drawing.paths()) text += path_text(drawing, path, scale);
  return text + "</g></defs>\n";
}

std::string SvgUses::path_text(const Recording& drawing, const Recording::Path& path, double scale) {
  std::string text = "<path d=\"";
  GridPoint pen{};
  for (const Recording::Contour& contour : drawing.contours(path)) {
    std::vector<Vec2> points;
    for (const Vec2 p : drawing.points(contour)) points.push_back(scale * p);
    const GridPoint start = data_.grid()(points.front());
    data_.start(start);
    std::vector<char> lines((points.size() + 1) * PathData::longest_command);
    const PathData::Lines drawn = data_.lines(lines.data(), std::span(points).subspan(1));
    std::string_view commands(lines.data(), static_cast<std::size_t>(drawn.end - lines.data()));
    if (drawn.count == 0) commands = "h0";  // a dot
    std::array<char, PathData::longest_command> move;
    const char* const end = data_.move(move.data(), {start.x - pen.x, start.y - pen.y}, commands.front());
    text += std::string_view(move.data(), static_cast<std::size_t>(end - move.data()));
    text += commands;
    const bool returns = path.head.closed && drawn.count > 0;
    if (returns) text += 'z';
    pen = returns ? start : data_.at();
  }
  return text + "\"/>";
}

}  // namespace burin::output
