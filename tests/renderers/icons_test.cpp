#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <burin/base/bytes.hpp>
#include <burin/data/svg/paths.hpp>
#include <burin/output/back_ends.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/draw_path.hpp>

#include "renderers/programs.hpp"

/// Icons drawn by other people's tools, as we read them and as librsvg shows them. BURIN_ICONS=FOLDER tries another
/// set.
namespace burin::test {
namespace {

namespace fs = std::filesystem;

constexpr int picture_px = 256;
constexpr double most_icon_rmse = 8.0;  ///< of 255

std::vector<fs::path> icons_in(const fs::path& folder, std::size_t every) {
  std::vector<fs::path> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".svg" && fs::is_regular_file(entry.symlink_status())) all.push_back(entry.path());
  }
  std::sort(all.begin(), all.end());
  std::vector<fs::path> some;
  for (std::size_t i = 0; i < all.size(); i += every) some.push_back(all[i]);
  return some;
}

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A page of whole pixels with a layer for each area and each stroke of the drawing, which lies in its middle.
class IconPage {
 public:
  explicit IconPage(const data::SvgDrawing& drawing) {
    const double longer = std::max(drawing.size_px.x, drawing.size_px.y);
    const Vec2 page{std::round(picture_px * drawing.size_px.x / longer),
                    std::round(picture_px * drawing.size_px.y / longer)};
    scale_ = std::min(page.x / drawing.size_px.x, page.y / drawing.size_px.y);
    offset_ = 0.5 * (page - scale_ * drawing.size_px);
    sheet_.page = {page.x, page.y, 0.0, {255, 255, 255}};
    for (const data::SvgShape& shape : drawing.shapes) {
      if (shape.fill) add_layer(shape, data::SvgParts::fills, shape.fill->color, 0.1, shape.fill->opacity);
      if (!shape.stroke) continue;
      const data::SvgStroke& stroke = *shape.stroke;
      SheetLayer& layer =
          add_layer(shape, data::SvgParts::strokes, stroke.color, scale_ * stroke.width, stroke.opacity);
      layer.cap = stroke.cap == "round" ? Cap::round : stroke.cap == "square" ? Cap::square : Cap::butt;
      layer.join = stroke.join == "round" ? Join::round : stroke.join == "bevel" ? Join::bevel : Join::miter;
      layer.miter_limit = stroke.miter_limit;
    }
  }

  /// Drawn into a PNG with one pixel a millimetre.
  std::string png() const {
    const auto rows = output::back_ends();
    const auto row = std::find_if(rows.begin(), rows.end(), [](const BackEnd& b) { return b.format == "png"; });
    StringSink bytes;
    OutputOptions options;
    options.dots_per_mm = 1.0;
    const std::unique_ptr<OutputSink> sink = row->open(bytes, sheet_, options);
    while (draw(*sink) == Flow::go && sink->wants_another_run()) continue;
    EXPECT_TRUE(sink->finish().ok());
    return bytes.take();
  }

 private:
  SheetLayer& add_layer(const data::SvgShape& shape, data::SvgParts parts, const std::string& color, double width_mm,
                        double opacity) {
    sheet_.pens.push_back({"pen", parse_colour(color).value_or(Colour{0, 0, 0}), width_mm});
    sheet_.layers.push_back({.name = "layer", .pen = sheet_.pens.size() - 1});
    sheet_.layers.back().opacity = opacity;
    data::SvgDrawing one;
    one.shapes.push_back(shape);
    paths_.push_back(data::svg_paths(one, parts));
    if (!paths_.back().empty()) sheet_.layers.back().paint = paint_of(paths_.back().front());
    return sheet_.layers.back();
  }

  static Paint paint_of(const data::SvgPath& path) {
    return path.paint == data::SvgPath::Paint::stroke         ? Paint::stroke
           : path.paint == data::SvgPath::Paint::fill_evenodd ? Paint::fill_evenodd
                                                              : Paint::fill_nonzero;
  }

  Flow draw(PathSink& sink) const {
    Mapped mapped(sink, translation(offset_) * scaling(scale_, scale_));
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      for (const data::SvgPath& path : paths_[i]) {
        const PathHead head{.layer = static_cast<LayerId>(i), .paint = paint_of(path), .closed = path.closed};
        if (draw_path(mapped, head, path.contours) == Flow::stop) return Flow::stop;
      }
    }
    return Flow::go;
  }

  double scale_ = 1.0;
  Vec2 offset_;
  Sheet sheet_;
  std::vector<std::vector<data::SvgPath>> paths_;
};

struct Tally {
  int alike = 0;
  int refused = 0;
  double worst = 0.0;
};

/// Every icon looks as librsvg shows it, or names what in it cannot be drawn.
Tally try_icons(const std::vector<fs::path>& icons) {
  Tally tally;
  const TemporaryFolder folder;
  for (const fs::path& icon : icons) {
    const Result<data::SvgDrawing> drawing = data::read_svg(contents(icon), icon.filename().string(), 1e-4);
    if (!drawing) {
      ADD_FAILURE() << icon << '\n' << problems_text(drawing.problems());
      continue;
    }
    if (!drawing->not_drawn.empty()) {
      EXPECT_GT(drawing->not_drawn.front().where.line, 0) << icon;
      ++tally.refused;
      continue;
    }
    std::ofstream(folder.file("ours.png"), std::ios::binary) << IconPage(*drawing).png();
    const GreyPicture ours = read_png(folder.file("ours.png"));
    run_in(folder, {"rsvg-convert", icon.string(), "-o", "theirs.png", "-w", std::to_string(ours.width), "-h",
                    std::to_string(ours.height), "--background-color", "white"});
    const double difference = rmse(ours, read_png(folder.file("theirs.png")));
    EXPECT_LE(difference, most_icon_rmse) << icon;
    tally.worst = std::max(tally.worst, difference);
    if (difference <= most_icon_rmse) ++tally.alike;
  }
  std::printf("%d alike (rmse at most %.2f of 255), %d refused\n", tally.alike, tally.worst, tally.refused);
  return tally;
}

TEST(Icons, Adwaita) {
  EXPECT_GE(try_icons(icons_in("/usr/share/icons/Adwaita", 5)).alike, 60);
}

// Painted with gradients and blurred shadows nearly throughout: each is refused with its reason.
TEST(Icons, Tango) {
  const Tally tally = try_icons(icons_in("/usr/share/icons/Tango", 8));
  EXPECT_GE(tally.alike + tally.refused, 20);
}

TEST(Icons, AnotherSet) {
  const char* folder = std::getenv("BURIN_ICONS");
  const std::vector<fs::path> icons =
      folder == nullptr ? icons_in(BURIN_SOURCE_DIR "/primitives", 1) : icons_in(folder, 1);
  EXPECT_GE(try_icons(icons).alike, 1);
}

}  // namespace
}  // namespace burin::test
