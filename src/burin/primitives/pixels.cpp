#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include <burin/geom/affine2.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/draw_path.hpp>
#include <burin/primitives/pixels.hpp>

namespace burin::primitives {

namespace {

constexpr std::string_view set_marks = "#Xx*@1";
constexpr std::string_view unset_marks = ". -_0\t";

Problem too_large(const Where& where) {
  return {where, fmt::format("a bitmap has at most {} pixels", max_bitmap_pixels), Trouble::limit};
}

/// The lines of the text without those that are empty at its beginning and end.
std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (!lines.empty() || !line.empty()) lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

/// The ways along the grid, counter-clockwise with y down turned up: right, up, left, down.
constexpr std::array<std::array<int, 2>, 4> ways{{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};

/// Walks around the set pixels with them on the left.
class Tracer {
 public:
  explicit Tracer(const Bitmap& bitmap)
      : bitmap_(bitmap),
        seen_((static_cast<std::size_t>(bitmap.width) + 1) * (static_cast<std::size_t>(bitmap.height) + 1)) {}

  std::vector<std::vector<Vec2>> trace() {
    std::vector<std::vector<Vec2>> contours;
    for (int row = 0; row <= bitmap_.height; ++row) {
      for (int column = 0; column <= bitmap_.width; ++column) {
        // Every contour has an edge that goes right: below a set pixel, at its lower left corner.
        if (is_edge(column, row, 0) && !seen(column, row)) contours.push_back(around(column, row));
      }
    }
    return contours;
  }

 private:
  /// Whether the grid edge from (column, row) in this way has a set pixel on its left and none on its right.
  bool is_edge(int column, int row, int way) const {
    // The pixels left and right of the edge, by the corner from which it starts.
    static constexpr std::array<std::array<int, 4>, 4> sides{
        {{0, -1, 0, 0}, {-1, -1, 0, -1}, {-1, 0, -1, -1}, {0, 0, -1, 0}}};
    const std::array<int, 4>& side = sides[static_cast<std::size_t>(way)];
    return bitmap_.at(column + side[0], row + side[1]) && !bitmap_.at(column + side[2], row + side[3]);
  }

  bool seen(int column, int row) const { return seen_[index(column, row)]; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * (static_cast<std::size_t>(bitmap_.width) + 1) +
           static_cast<std::size_t>(column);
  }

  std::vector<Vec2> around(int column, int row) {
    std::vector<Vec2> contour;
    const int first_column = column;
    const int first_row = row;
    int way = 0;
    do {
      if (way == 0) seen_[index(column, row)] = true;
      column += ways[static_cast<std::size_t>(way)][0];
      row += ways[static_cast<std::size_t>(way)][1];
      // Left before straight before right keeps pixels apart that touch at a corner.
      for (const int turn : {1, 0, 3}) {
        const int next = (way + turn) % 4;
        if (!is_edge(column, row, next)) continue;
        if (turn != 0) contour.push_back({static_cast<double>(column), static_cast<double>(-row)});
        way = next;
        break;
      }
    } while (column != first_column || row != first_row || way != 0);
    return contour;
  }

  const Bitmap& bitmap_;
  std::vector<bool> seen_;  ///< edges that go right, by where they start
};

}  // namespace

Result<Bitmap> bitmap_from_text(std::string_view text, const Where& where) {
  const std::vector<std::string_view> lines = lines_of(text);
  Bitmap bitmap;
  std::size_t width = 0;
  for (const std::string_view line : lines) width = std::max(width, line.size());
  if (width * lines.size() > max_bitmap_pixels) return too_large(where);
  bitmap.width = static_cast<int>(width);
  bitmap.height = static_cast<int>(lines.size());
  bitmap.set.resize(width * lines.size());
  for (std::size_t row = 0; row < lines.size(); ++row) {
    for (std::size_t column = 0; column < lines[row].size(); ++column) {
      const char mark = lines[row][column];
      const bool is_set = set_marks.find(mark) != std::string_view::npos;
      if (!is_set && unset_marks.find(mark) == std::string_view::npos) {
        return Problem{where,
                       fmt::format("line {} of the bitmap, character {}: '#' sets a pixel and '.' does not; this is "
                                   "neither",
                                   row + 1, column + 1)};
      }
      bitmap.set[row * width + column] = is_set;
    }
  }
  return bitmap;
}

Result<Bitmap> bitmap_from_image(const data::Image& image, const std::string& file) {
  constexpr int middle_grey = 128 * 1000;
  if (image.width > max_bitmap_pixels / image.height) return too_large({file});
  Bitmap bitmap{image.width, image.height, {}};
  bitmap.set.reserve(image.rgba.size() / 4);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const std::uint8_t* p = image.pixel(column, row);
      bitmap.set.push_back(p[3] >= 128 && 299 * p[0] + 587 * p[1] + 114 * p[2] < middle_grey);
    }
  }
  return bitmap;
}

std::vector<std::vector<Vec2>> outline_of(const Bitmap& bitmap) {
  return Tracer(bitmap).trace();
}

std::optional<Primitive> primitive_of(const Bitmap& bitmap, std::optional<PixelPlace> anchor, Paint paint,
                                      std::string name) {
  const std::vector<std::vector<Vec2>> outline = outline_of(bitmap);
  if (outline.empty()) return std::nullopt;
  Box2 box;
  for (const std::vector<Vec2>& contour : outline) {
    for (const Vec2 p : contour) box.add(p);
  }
  const Vec2 at = anchor ? Vec2{anchor->column + 0.5, -anchor->row - 0.5} : box.center();
  const double unit = 1.0 / std::max(box.width(), box.height());
  Recorder recorder;
  Mapped mapped(recorder, scaling(unit, unit) * translation(-at));
  static_cast<void>(draw_path(mapped, {.paint = paint, .closed = true}, outline));
  Primitive primitive;
  primitive.name = name;
  primitive.title = std::move(name);
  primitive.figure = std::make_shared<const Figure>(recorder.take());
  return primitive;
}

}  // namespace burin::primitives
