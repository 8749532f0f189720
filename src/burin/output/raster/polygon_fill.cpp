#include <algorithm>
#include <tuple>

#include <burin/output/raster/polygon_fill.hpp>

namespace burin::output::raster {

namespace {

/// The samples of a row of pixels lie on 64 level lines, one of each pixel on each line, 16 units apart.
constexpr int lines = 64;
constexpr int line_y(int line) {
  return 16 * line + 8;
}
constexpr int row_of(int line) {
  return line / 8;
}
constexpr int column_of(int line) {
  return 7 - line % 8;
}
static_assert(line_y(13) == sample_y(row_of(13), column_of(13)) && line_y(56) == sample_y(row_of(56), column_of(56)));

constexpr std::int64_t divided_up(std::int64_t a, std::int64_t b) {
  return a / b + (a % b > 0 ? 1 : 0);
}

}  // namespace

void PolygonFill::add_contour(const std::vector<Point>& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point a = points[k];
    const Point b = points[k + 1 < points.size() ? k + 1 : 0];
    if (a.y < b.y) edges_.push_back({a, b, 1});
    if (a.y > b.y) edges_.push_back({b, a, -1});
  }
}

void PolygonFill::fill(bool evenodd, const PixelBox& clip, MaskTiles& tiles) {
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.from.y < b.from.y; });
  std::vector<Edge> active;
  auto next = edges_.begin();
  for (int j = clip.top; j < clip.bottom; ++j) {
    if (!tiles.share().has(j)) continue;
    const std::int64_t top = std::int64_t{j} * units_per_pixel;
    std::erase_if(active, [&](const Edge& edge) { return edge.to.y <= top; });
    for (; next != edges_.end() && next->from.y < top + units_per_pixel; ++next) {
      if (next->to.y > top) active.push_back(*next);
    }
    if (active.empty()) {
      if (next == edges_.end()) break;
      continue;
    }
    toggles_.assign(static_cast<std::size_t>(clip.width()), 0);
    crossings_.clear();
    for (const Edge& edge : active) cross_row(edge, j, clip);
    if (evenodd) {
      for (const Crossing& crossing : crossings_) {
        toggles_[static_cast<std::size_t>(crossing.pixel - clip.left)] ^=
            sample_bit(row_of(crossing.line), column_of(crossing.line));
      }
    } else {
      toggle_where_winding_starts_or_ends(clip);
    }
    spill_row(j, clip, tiles);
  }
  edges_.clear();
}

void PolygonFill::cross_row(const Edge& edge, int j, const PixelBox& clip) {
  const std::int64_t top = std::int64_t{j} * units_per_pixel;
  const std::int64_t dx = std::int64_t{edge.to.x} - edge.from.x;
  const std::int64_t dy = std::int64_t{edge.to.y} - edge.from.y;
  // From the first line on or below the edge's start to the last above its end.
  const auto first = std::max<std::int64_t>(0, divided_up(edge.from.y - top - line_y(0), 16));
  const auto end = std::min<std::int64_t>(lines, divided_up(edge.to.y - top - line_y(0), 16));
  for (auto line = static_cast<int>(first); line < end; ++line) {
    const std::int64_t down = top + line_y(line) - edge.from.y;
    const std::int64_t sample = sample_x(row_of(line), column_of(line));
    const std::int64_t pixel = divided_up((edge.from.x - sample) * dy + down * dx, dy * units_per_pixel);
    if (pixel >= clip.right) continue;
    crossings_.push_back({line, static_cast<int>(std::max<std::int64_t>(pixel, clip.left)), edge.winding});
  }
}

void PolygonFill::toggle_where_winding_starts_or_ends(const PixelBox& clip) {
  std::sort(crossings_.begin(), crossings_.end(),
            [](const Crossing& a, const Crossing& b) { return std::tie(a.line, a.pixel) < std::tie(b.line, b.pixel); });
  int winding = 0;
  for (std::size_t k = 0; k < crossings_.size(); ++k) {
    const Crossing& crossing = crossings_[k];
    if (k == 0 || crossings_[k - 1].line != crossing.line) winding = 0;
    const int before = winding;
    winding += crossing.winding;
    if ((before == 0) == (winding == 0)) continue;
    toggles_[static_cast<std::size_t>(crossing.pixel - clip.left)] ^=
        sample_bit(row_of(crossing.line), column_of(crossing.line));
  }
}

void PolygonFill::spill_row(int j, const PixelBox& clip, MaskTiles& tiles) {
  Samples inside = 0;
  for (int i = clip.left; i < clip.right;) {
    const int end = std::min(clip.right, MaskTiles::end_of_tile(i));
    const auto toggle = toggles_.begin() + (i - clip.left);
    const bool blank = inside == 0 && std::all_of(toggle, toggle + (end - i), [](Samples s) { return s == 0; });
    if (blank) {
      i = end;
      continue;
    }
    Samples* samples = tiles.at(i, j, 0);
    for (; i < end; ++i, ++samples) {
      inside ^= toggles_[static_cast<std::size_t>(i - clip.left)];
      *samples |= inside;
    }
  }
}

}  // namespace burin::output::raster
