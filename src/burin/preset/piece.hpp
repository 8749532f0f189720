#pragma once

#include <any>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <burin/curves/family.hpp>
#include <burin/params/fields.hpp>
#include <burin/path/sheet.hpp>
#include <burin/preset/clip_spec.hpp>
#include <burin/primitives/placing.hpp>

/// A preset after reading and before planning: every knob set, every name resolved, every value in its range. The
/// structs here are the field tables of the preset format; their rows are its documentation.
namespace burin::preset {

struct About {
  std::string title;
  std::string author;
  std::string summary;

  static constexpr auto fields() {
    return std::tuple{params::field("title", &About::title, "name of the picture, written into every file"),
                      params::field("author", &About::author, "who made it, written into every file"),
                      params::field("summary", &About::summary, "one sentence for lists and galleries")};
  }
};

/// A named paper ("a4", "letter") or "30x40cm"; portrait as named.
struct PageSize {
  double width_mm = 210.0;
  double height_mm = 297.0;
};

/// "30mm", "20mm 30mm" (top and bottom, left and right) or four, clockwise from the top, as in CSS.
struct Margins {
  double top_mm = 0.0;
  double right_mm = 0.0;
  double bottom_mm = 0.0;
  double left_mm = 0.0;
};

struct PageSpec {
  PageSize size;
  Margins margin{25.0, 25.0, 32.0, 25.0};
  Colour paper{255, 255, 255};
  params::Length bleed;
  bool landscape = false;

  static constexpr auto fields() {
    return std::tuple{
        params::field("size", &PageSpec::size, "a named paper such as a4, a3, letter, square, or \"30x40cm\""),
        params::field("margin", &PageSpec::margin, "one to four lengths, clockwise from the top"),
        params::field("paper", &PageSpec::paper, "colour of the paper: a name or #rrggbb; shown in PNG"),
        params::field("bleed", &PageSpec::bleed, {0.0, 100.0}, "how far ink may run over the trimmed edge"),
        params::field("landscape", &PageSpec::landscape, "turn the page on its side")};
  }
};

struct PenSpec {
  Colour color;
  params::Length width{0.3};
  std::optional<std::array<double, 4>> cmyk;
  std::string spot;

  static constexpr auto fields() {
    return std::tuple{
        params::field("color", &PenSpec::color, "a name or #rrggbb"),
        params::field("width", &PenSpec::width, {0.0, 100.0, true, false}, "width of its line"),
        params::field("cmyk", &PenSpec::cmyk,
                      "[c, m, y, k], inks in percent, for the PDF of --backend native; other formats use 'color'"),
        params::field("spot", &PenSpec::spot,
                      "name of a spot ink such as \"Pantone 485 C\", for the same PDF; unset: none")};
  }
};

/// A coordinate or an extent in a slot: millimetres, or a share of the live area.
struct Extent {
  double value = 0.0;
  bool percent = false;
};

/// "x y w h" in the live area, y down from its top left corner.
struct SlotRect {
  Extent x{0.0, true};
  Extent y{0.0, true};
  Extent width{100.0, true};
  Extent height{100.0, true};
};

/// Where the drawing lies in its slot when it does not fill it: -1 left or top, 0 center, 1 right or bottom.
struct Align {
  int x = 0;
  int y = 0;
};

enum class Mirror : std::uint8_t { none, x, y, xy };
constexpr auto words(Mirror) {
  return std::array<params::Word<Mirror>, 4>{
      {{"none", Mirror::none}, {"x", Mirror::x}, {"y", Mirror::y}, {"xy", Mirror::xy}}};
}

/// Columns and rows.
struct Grid {
  int columns = 1;
  int rows = 1;
};

/// A symmetry group by name: rosettes c1, c2 ..., d1, d2 ...; friezes p111, p1a1, p1m1, pm11, p112, pma2, pmm2;
/// wallpapers p1, p2, pm, pg, pmm, p4, p4m, p3, p6, p6m. Empty: none.
struct SymmetryName {
  std::string name;
};

struct SlotSpec {
  SlotRect at;
  Align align;
  double rotate = 0.0;
  std::optional<params::Length> scale;
  std::optional<std::array<double, 4>> frame;
  Mirror mirror = Mirror::none;
  Grid grid;
  params::Length gap;
  SymmetryName symmetry;
  std::optional<params::Length> cell;

  static constexpr auto fields() {
    return std::tuple{
        params::field("at", &SlotSpec::at, "\"x y w h\" in the live area: lengths or percents of it"),
        params::field("align", &SlotSpec::align, "left, center, right and top, middle, bottom; one or two words"),
        params::field("rotate", &SlotSpec::rotate, {-3600.0, 3600.0}, "turn in degrees, counter-clockwise"),
        params::field("scale", &SlotSpec::scale, params::positive, "length of one model unit; unset: fit the slot"),
        params::field("frame", &SlotSpec::frame,
                      "[x0, y0, x1, y1] in model units: what the slot shows; unset: the ink"),
        params::field("mirror", &SlotSpec::mirror,
                      "flip left-right (x), top-bottom (y) or both; in a grid every other one"),
        params::field("grid", &SlotSpec::grid, "[columns, rows] of copies"),
        params::field("gap", &SlotSpec::gap, params::not_negative, "space between the copies of a grid"),
        params::field("symmetry", &SlotSpec::symmetry,
                      "a rosette c6 d6, a frieze pmm2, a wallpaper p4m; about the model's origin"),
        params::field("cell", &SlotSpec::cell, params::positive,
                      "side of the translation cell of a frieze or wallpaper; unset: a quarter of the slot")};
  }
};

/// Which pen draws where: one pen, pens in turn, or bands. "none" draws nothing.
inline constexpr std::string_view no_pen = "none";
struct PenChoice : primitives::Choice<std::string> {
  /// Two pens between which pens of a layer's own are made, one for each level or band; `of` then follows from them.
  std::string from;
  std::string to;
};

enum class FillRule : std::uint8_t { nonzero, evenodd };
constexpr auto words(FillRule) {
  return std::array<params::Word<FillRule>, 2>{{{"nonzero", FillRule::nonzero}, {"evenodd", FillRule::evenodd}}};
}

/// The keys of a layer besides its source (`curve` or `text`), which the layer reader takes apart itself.
struct LayerStyle {
  std::string name;
  std::string slot;
  PenChoice pen;
  std::string fill;
  FillRule rule = FillRule::nonzero;
  std::string stroke;
  Cap caps = Cap::round;
  Join joins = Join::round;
  double miter = 4.0;
  std::vector<params::Length> dashes;
  double opacity = 1.0;
  std::int64_t seed = 0;
  std::optional<primitives::PlacingSpec> primitives;
  bool hide = false;
  std::string hidden;
  std::optional<ClipSpec> clip;
  std::optional<ClipSpec> outside;

  static constexpr auto fields() {
    return std::tuple{
        params::field("name", &LayerStyle::name, "name of the layer; unset: its curve's, or text"),
        params::field("slot", &LayerStyle::slot, "where it is drawn; unset: the live area"),
        params::field("pen", &LayerStyle::pen,
                      "a pen, a list that takes turns, { by = \"f(x,y)\", at = [...], of = [...] } or { from, to }; "
                      "unset: the first"),
        params::field("fill", &LayerStyle::fill, "pen whose colour fills the closed paths; unset: no fill"),
        params::field("rule", &LayerStyle::rule, "which side of a crossing curve is inside"),
        params::field("stroke", &LayerStyle::stroke, "\"none\": fill only, or hide and clip only"),
        params::field("caps", &LayerStyle::caps, "ends of open lines"),
        params::field("joins", &LayerStyle::joins, "corners"),
        params::field("miter", &LayerStyle::miter, {1.0, 1000.0}, "longest miter, in line widths"),
        params::field("dashes", &LayerStyle::dashes, params::not_negative,
                      "lengths on, off, on ...; unset: a full line"),
        params::field("opacity", &LayerStyle::opacity, {0.0, 1.0}, "of the layer as a whole"),
        params::field("seed", &LayerStyle::seed, "mixed into the piece's seed; 0: the piece's own"),
        params::field("primitives", &LayerStyle::primitives,
                      "figures along the curve in place of its line: { use = \"leaf\", every = \"6mm\" }"),
        params::field("hide", &LayerStyle::hide,
                      "cut away what its closed paths cover: lower layers, and its own earlier paths and figures"),
        params::field("hidden", &LayerStyle::hidden, "pen for the lines that others hide; unset: they are left out"),
        params::field("clip", &LayerStyle::clip,
                      "show only what lies inside a layer's closed paths, by its name, or { shape = \"disc\", r = "
                      "\"70mm\" }; lines are cut"),
        params::field("outside", &LayerStyle::outside, "the same for what lies outside")};
  }
};

/// A layer with its source.
struct Layer {
  Where where;
  LayerStyle style;
  const curves::Family* family = nullptr;
  std::any parameters;            ///< of the finest level
  std::vector<std::any> coarser;  ///< of the levels that are drawn before it, the coarsest first
  int first_level = 0;            ///< the coarsest of several
  primitives::Figures figures;    ///< of style.primitives, one for each name

  std::size_t level_count() const { return coarser.size() + 1; }
  /// Pre: level < level_count().
  const std::any& level_parameters(std::size_t level) const {
    return level < coarser.size() ? coarser[level] : parameters;
  }
};

struct NamedPen {
  std::string name;
  PenSpec pen;
};

struct NamedSlot {
  std::string name;
  SlotSpec slot;
};

struct Piece {
  About about;
  PageSpec page;
  std::optional<PageSize> enlarge_onto;  ///< scale the finished sheet to fit this page
  std::uint64_t seed = 1;
  std::vector<NamedPen> pens;            ///< in file order, at least one
  std::vector<NamedSlot> slots;          ///< in file order
  std::vector<Layer> layers;             ///< in file order, at least one
  std::vector<params::DataDigest> data;  ///< every data file that was read
  std::vector<std::string> warnings{};   ///< what was read otherwise than it is written, for people
  bool seed_in_values = false;           ///< whether a random knob or $seed went into the values above
};

}  // namespace burin::preset
