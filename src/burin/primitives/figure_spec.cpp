#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <burin/primitives/figure_spec.hpp>
#include <burin/primitives/library.hpp>
#include <burin/primitives/pixels.hpp>

namespace burin::primitives {

namespace {

/// The keys of a figure.
struct FigureSpec {
  std::string file;
  std::string d;
  std::string pixels;
  std::vector<double> anchor;
  std::vector<double> up;
  std::vector<int> anchor_pixel;
  std::optional<bool> fill;
  bool partial = false;

  static constexpr auto fields() {
    return std::tuple{
        params::field("file", &FigureSpec::file, "an SVG, or a PNG whose dark pixels are set, relative to the preset"),
        params::field("d", &FigureSpec::d, "SVG path data, y down as in SVG"),
        params::field("pixels", &FigureSpec::pixels, "a bitmap as lines of text, '#' for set and '.' for unset pixels"),
        params::field("anchor", &FigureSpec::anchor, "[x, y] in the units of `d`; unset: the middle of its box"),
        params::field("up", &FigureSpec::up, "[x, y], the way that is up in `d`; unset: [0, -1]"),
        params::field(
            "anchor_pixel", &FigureSpec::anchor_pixel,
            "[column, row] of the pixel whose middle is the anchor, from 0 at the top left; unset: the middle of "
            "the set pixels' box"),
        params::field("fill", &FigureSpec::fill,
                      "whether it is an area or lines; unset: pixels are an area, `d` is lines, an SVG is as it says"),
        params::field(
            "partial", &FigureSpec::partial,
            "leave out what cannot be drawn of an SVG (text, pictures, gradients ...) instead of refusing it")};
  }
};

bool ends_in(std::string_view name, std::string_view suffix) {
  return name.size() > suffix.size() && name.substr(name.size() - suffix.size()) == suffix;
}

/// Takes one figure's table apart.
class FigureReader {
 public:
  FigureReader(const FigureSpec& spec, const std::string& name, const Where& where, params::ReadContext& context,
               double tolerance)
      : spec_(spec), name_(name), where_(where), context_(context), tolerance_(tolerance) {}

  std::optional<Primitive> read() {
    if (int{!spec_.file.empty()} + int{!spec_.d.empty()} + int{!spec_.pixels.empty()} != 1) {
      return fail("a figure needs exactly one of 'file', 'd' and 'pixels'");
    }
    const bool is_bitmap = !spec_.pixels.empty() || ends_in(spec_.file, ".png");
    if (!are_pairs()) return std::nullopt;
    if (!spec_.anchor_pixel.empty() && !is_bitmap) return fail("'anchor_pixel' is for pixels; a path has an 'anchor'");
    if ((!spec_.anchor.empty() || !spec_.up.empty()) && spec_.d.empty()) {
      return fail(is_bitmap
                      ? "'anchor' and 'up' are for path data; pixels have an 'anchor_pixel'"
                      : "'anchor' and 'up' are for path data; in an SVG the object labelled \"anchor\" says them");
    }
    std::optional<Primitive> figure = is_bitmap ? read_bitmap() : spec_.d.empty() ? read_svg() : read_path();
    if (figure) figure->name = name_;
    return figure;
  }

 private:
  std::nullopt_t fail(std::string message) {
    context_.report(where_, fmt::format("figure '{}': {}", name_, message));
    return std::nullopt;
  }
  std::nullopt_t fail(const Problems& problems) {
    for (Problem problem : problems) {
      if (problem.where.file.empty()) problem.where = where_;
      context_.problems.push_back(std::move(problem));
    }
    return std::nullopt;
  }

  bool are_pairs() {
    const auto is_pair = [this](std::size_t size, std::string_view key) {
      if (size == 0 || size == 2) return true;
      fail(fmt::format("'{}' is a pair of numbers, not {}", key, size));
      return false;
    };
    return is_pair(spec_.anchor.size(), "anchor") && is_pair(spec_.up.size(), "up") &&
           is_pair(spec_.anchor_pixel.size(), "anchor_pixel");
  }

  /// The path, filled or stroked as `fill` says.
  std::optional<Primitive> read_path() {
    Result<std::vector<data::Subpath>> coarse = data::parse_svg_path(spec_.d, 1e-3, where_);
    if (!coarse) return fail(coarse.problems());
    const auto drawing_of = [this](std::vector<data::Subpath> subpaths) {
      data::SvgDrawing drawing;
      drawing.shapes.push_back({std::move(subpaths), std::nullopt, std::nullopt});
      if (spec_.fill.value_or(false)) {
        drawing.shapes.back().fill = data::SvgFill{};
      } else {
        drawing.shapes.back().stroke = data::SvgStroke{};
      }
      return drawing;
    };
    const Box2 box = drawing_of(*coarse).box();
    const double side = box.empty() ? 0.0 : std::max(box.width(), box.height());
    Result<std::vector<data::Subpath>> fine =
        side > 0.0 ? data::parse_svg_path(spec_.d, tolerance_ * side, where_) : std::move(coarse);
    if (!fine) return fail(fine.problems());
    data::SvgDrawing drawing = drawing_of(*std::move(fine));
    if (!spec_.anchor.empty() || !spec_.up.empty()) {
      const Vec2 at = spec_.anchor.empty() ? box.center() : Vec2{spec_.anchor[0], spec_.anchor[1]};
      const Vec2 up = spec_.up.empty() ? Vec2{0.0, -1.0} : Vec2{spec_.up[0], spec_.up[1]};
      if (!(length_squared(up) > 0.0)) return fail("'up' has no direction");
      drawing.anchor = data::SvgAnchor{at, up};
    }
    std::optional<Primitive> figure = primitive_of(drawing, name_);
    if (!figure) return fail("its path draws nothing");
    return figure;
  }

  std::optional<Primitive> read_svg() {
    const Result<std::string> text = context_.read_file(spec_.file);
    if (!text) return fail(text.problems());
    const Leftovers leftovers = spec_.partial ? Leftovers::are_left_out : Leftovers::are_errors;
    Result<Primitive> figure = read_primitive_svg(*text, spec_.file, tolerance_, leftovers);
    if (!figure) return fail(figure.problems());
    if (spec_.fill) return fail("an SVG says itself what is filled; leave out 'fill'");
    return *std::move(figure);
  }

  Result<Bitmap> bitmap() {
    if (!spec_.pixels.empty()) return bitmap_from_text(spec_.pixels, where_);
    const Result<std::string> bytes = context_.read_file(spec_.file);
    if (!bytes) return bytes.problems();
    const Result<data::Image> image = data::read_png(*bytes, spec_.file);
    if (!image) return image.problems();
    return bitmap_from_image(*image, spec_.file);
  }

  std::optional<Primitive> read_bitmap() {
    const Result<Bitmap> read = bitmap();
    if (!read) return fail(read.problems());
    std::optional<PixelPlace> anchor;
    if (!spec_.anchor_pixel.empty()) anchor = PixelPlace{spec_.anchor_pixel[0], spec_.anchor_pixel[1]};
    const Paint paint = spec_.fill.value_or(true) ? Paint::fill_nonzero : Paint::stroke;
    std::optional<Primitive> figure = primitive_of(*read, anchor, paint, name_);
    if (!figure) return fail("no pixel of it is set");
    return figure;
  }

  const FigureSpec& spec_;
  const std::string& name_;
  Where where_;
  params::ReadContext& context_;
  double tolerance_;
};

/// "M0 0L1 1": what no file and no figure is called.
bool is_path_data(std::string_view name) {
  return name.size() > 3 && (name[0] == 'M' || name[0] == 'm') &&
         std::string_view(" +-.0123456789").find(name[1]) != std::string_view::npos;
}

}  // namespace

std::optional<Primitive> read_figure_table(const params::Table& table, const std::string& name, const Where& where,
                                           params::ReadContext& context, double tolerance) {
  FigureSpec spec;
  if (!params::read_fields(table, spec, "figure '" + name + "'", context)) return std::nullopt;
  return FigureReader(spec, name, where, context, tolerance).read();
}

std::optional<Primitive> read_figure(const std::string& name, const Where& where, params::ReadContext& context,
                                     double tolerance) {
  FigureSpec spec;
  if (is_path_data(name)) {
    spec.d = name;
  } else if (ends_in(name, ".png")) {
    spec.file = name;
  } else {
    const params::Value* defined = context.defined ? context.defined(name) : nullptr;
    if (defined != nullptr && defined->table() != nullptr) {
      return read_figure_table(*defined->table(), name, defined->where, context, tolerance);
    }
    Result<Primitive> found = find_primitive(name, context.read_file, tolerance);
    if (found) return *std::move(found);
    for (Problem problem : found.problems()) {
      if (problem.where.file.empty()) problem.where = where;
      context.problems.push_back(std::move(problem));
    }
    return std::nullopt;
  }
  return FigureReader(spec, name, where, context, tolerance).read();
}

std::vector<params::FieldInfo> figure_fields() {
  return params::field_infos<FigureSpec>();
}

}  // namespace burin::primitives
