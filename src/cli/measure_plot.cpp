#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <burin/base/math.hpp>
#include <burin/curves/text/text.hpp>
#include <cli/measure_plot.hpp>

namespace burin::cli {

namespace {

constexpr Page page{160.0, 146.0, 0.0, {255, 255, 255}};
constexpr Box2 field{{28.0, 24.0}, {148.0, 118.0}};  ///< where the plot is, y down
constexpr double tick_mm = 2.0;
constexpr double dot_mm = 1.1;

enum Layer : LayerId { axes, dots, line };

/// Draws pieces of the plot until the sink says stop.
class Pencil {
 public:
  explicit Pencil(PathSink& sink) : sink_(sink) {}

  Flow path(Layer layer, std::span<const Vec2> points, bool closed = false) {
    if (sink_.begin({.layer = layer, .closed = closed}) == Flow::stop || sink_.points(points) == Flow::stop) {
      return Flow::stop;
    }
    return sink_.end();
  }

  Flow segment(Layer layer, Vec2 from, Vec2 to) { return path(layer, std::array{from, to}); }

  Flow circle(Layer layer, Vec2 centre, double radius) {
    constexpr int corners = 24;
    std::vector<Vec2> points;
    for (int i = 0; i < corners; ++i) {
      const double angle = math::tau * i / corners;
      points.push_back(centre + radius * Vec2{math::cos(angle), math::sin(angle)});
    }
    return path(layer, points, true);
  }

  /// Letters of this height, y down, their baseline at `at`.
  Flow text(const std::string& words, Vec2 at, double height_mm, curves::TextAlign align) {
    curves::TextParams params;
    params.text.text = words;
    params.align = align;
    return curves::draw_text(params, {height_mm, 0.0, 0.0, -height_mm, at.x, at.y}, {.layer = axes}, sink_);
  }

 private:
  PathSink& sink_;
};

/// Whole numbers from the first to the last, in steps that leave at most eight.
std::vector<double> ticks(double low, double high) {
  const double step = std::max(1.0, std::ceil((high - low) / 8.0));
  std::vector<double> all;
  for (double tick = std::ceil(low); tick <= high; tick += step) all.push_back(tick);
  return all;
}

}  // namespace

Sheet box_plot_sheet(const std::string& title) {
  Sheet sheet;
  sheet.page = page;
  sheet.pens = {{"ink", {20, 20, 20}, 0.25}, {"dots", {20, 20, 20}, 0.35}, {"fit", {192, 57, 43}, 0.5}};
  sheet.layers = {{"axes", 0}, {"counts", 1}, {"fit", 2}};
  sheet.made_by.title = title;
  return sheet;
}

Flow draw_box_plot(const measure::BoxDimension& fit, const std::string& title, PathSink& sink) {
  const double ln2 = math::log(2.0);
  const auto log2_of = [&](double x) { return math::log(x) / ln2; };
  Box2 logs;
  for (const measure::BoxScale& scale : fit.scales) {
    logs.add(Vec2{log2_of(fit.extent / scale.side), log2_of(scale.count)});
  }
  logs = logs.grown(0.5);
  const auto place = [&](Vec2 log) {
    return Vec2{field.low.x + (log.x - logs.low.x) / logs.width() * field.width(),
                field.high.y - (log.y - logs.low.y) / logs.height() * field.height()};
  };
  Pencil pencil(sink);
  const std::array corner{Vec2{field.low.x, field.low.y}, Vec2{field.low.x, field.high.y}, field.high};
  if (pencil.path(axes, corner) == Flow::stop) return Flow::stop;
  for (const double tick : ticks(logs.low.x, logs.high.x)) {
    const Vec2 at{place({tick, 0.0}).x, field.high.y};
    if (pencil.segment(axes, at, at + Vec2{0.0, tick_mm}) == Flow::stop) return Flow::stop;
    if (pencil.text(fmt::format("{}", tick), at + Vec2{0.0, 6.0}, 2.5, curves::TextAlign::center) == Flow::stop) {
      return Flow::stop;
    }
  }
  for (const double tick : ticks(logs.low.y, logs.high.y)) {
    const Vec2 at{field.low.x, place({0.0, tick}).y};
    if (pencil.segment(axes, at, at - Vec2{tick_mm, 0.0}) == Flow::stop) return Flow::stop;
    if (pencil.text(fmt::format("{}", tick), at + Vec2{-4.0, 1.25}, 2.5, curves::TextAlign::right) == Flow::stop) {
      return Flow::stop;
    }
  }
  struct Line {
    Vec2 at;
    double height_mm;
    std::string words;
  };
  const std::array lines{
      Line{{field.low.x, 10.0}, 4.0, title},
      Line{{field.low.x, 17.0}, 3.0, fmt::format("dimension {:.4f} ± {:.4f}", fit.dimension, fit.standard_error)},
      Line{{field.low.x, 133.0}, 2.5, "across: log2 of boxes along the longer side"},
      Line{{field.low.x, 138.0}, 2.5, "up: log2 of boxes met"}};
  for (const Line& each : lines) {
    if (pencil.text(each.words, each.at, each.height_mm, curves::TextAlign::left) == Flow::stop) return Flow::stop;
  }
  for (const measure::BoxScale& scale : fit.scales) {
    const Vec2 at = place({log2_of(fit.extent / scale.side), log2_of(scale.count)});
    if (pencil.circle(dots, at, dot_mm) == Flow::stop) return Flow::stop;
  }
  const auto fitted = [&](double log_boxes) {
    const double side = fit.extent / math::exp(log_boxes * ln2);
    return place({log_boxes, (fit.intercept - fit.dimension * math::log(side)) / ln2});
  };
  return pencil.segment(line, fitted(logs.low.x + 0.25), fitted(logs.high.x - 0.25));
}

}  // namespace burin::cli
