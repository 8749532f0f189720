#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <burin/geom/box2.hpp>
#include <burin/path/colour.hpp>

namespace burin {

/// The paper and its edges, in millimetres from the top left corner, y down.
struct Page {
  double width_mm = 210.0;
  double height_mm = 297.0;
  double bleed_mm = 0.0;
  Colour paper{255, 255, 255};  ///< shown in PNG; in SVG and PDF only on request
};

/// What draws: as on a plotter, a colour and a width. A printer may know the colour better, as inks: the native PDF
/// says these, and `colour` is what a screen shows of a spot colour without `cmyk`.
struct Pen {
  std::string name;
  Colour colour;
  double width_mm = 0.3;
  std::optional<Cmyk> cmyk{};
  std::string spot{};  ///< name of an ink of its own, for example "Pantone 485 C"; empty: none
};

enum class Cap : std::uint8_t { round, butt, square };
enum class Join : std::uint8_t { round, miter, bevel };
enum class Paint : std::uint8_t { stroke, fill_nonzero, fill_evenodd };

/// One pass of one pen over the page. The order of the layers is the order of drawing. A layer's strokes are one union:
/// with opacity they do not darken each other.
struct SheetLayer {
  std::string name;
  std::size_t pen = 0;  ///< index into Sheet::pens
  Paint paint = Paint::stroke;
  Cap cap = Cap::round;
  Join join = Join::round;
  double miter_limit = 4.0;
  std::vector<double> dashes_mm{};  ///< on, off, on ...; empty: a full line
  double dash_offset_mm = 0.0;
  double opacity = 1.0;
};

/// What a drawing was made from; goes into every file so that it can be drawn again. Never a date or a host.
struct Origin {
  std::string title;
  std::string author;
  std::string summary;
  std::string record;  ///< the whole preset text, overrides, seed, page and format flags, digests, version, as TOML
};

/// All that is known of a drawing before its first point.
struct Sheet {
  Page page;
  std::vector<Pen> pens;
  std::vector<SheetLayer> layers;
  Origin made_by;
};

/// "1 ink 0.3": the pen's number (from 1, in file order), name and width, as layers are called in SVG and PDF.
std::string layer_label(const Sheet& sheet, std::size_t layer);

}  // namespace burin
