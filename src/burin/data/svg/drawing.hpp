#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/data/svg_path.hpp>
#include <burin/geom/box2.hpp>

namespace burin::data {

/// How an SVG's shape is stroked; lengths in pixels.
struct SvgStroke {
  std::string color;
  double opacity = 1.0;
  double width = 1.0;
  std::string cap;   ///< butt, round, square
  std::string join;  ///< miter, round, bevel
  double miter_limit = 4.0;
  std::vector<double> dashes{};  ///< on, off, on ...; empty: a full line
  double dash_offset = 0.0;
};

/// How it is filled.
struct SvgFill {
  std::string color;
  double opacity = 1.0;
  bool evenodd = false;
};

/// One shape of an SVG that can be seen, with every transform applied: CSS pixels of its viewport, y down.
struct SvgShape {
  std::vector<Subpath> subpaths;
  std::optional<SvgFill> fill;
  std::optional<SvgStroke> stroke;
};

/// The object that is labelled "anchor": where it is, and, when it is a line, which way is up.
struct SvgAnchor {
  Vec2 at;
  std::optional<Vec2> up;  ///< not zero
};

/// What an SVG says of itself.
struct SvgAbout {
  std::string title;
  std::string creator;
  std::string licence;  ///< dc:rights, else the address of cc:license
  std::string subject;  ///< the words of dc:subject
};

/// An SVG as shapes.
struct SvgDrawing {
  Vec2 size_px;  ///< of its viewport
  std::vector<SvgShape> shapes;
  std::optional<SvgAnchor> anchor;
  SvgAbout about;
  Problems not_drawn;  ///< what it holds beyond shapes: text, pictures, gradients, clip paths ..., each with its line

  /// The box of the shapes' outlines, without the widths of their strokes.
  Box2 box() const;
};

/// Reads an SVG: groups, transforms, shapes, `use`, viewBox, units, style attributes and style sheets. Curves become
/// chords that miss them by at most `relative_tolerance` times the longer side of the drawing's box. Problems (with
/// `file`, line and column): no SVG, a `use` that refers to itself, more than 100,000 elements or 2^20 points or 200
/// groups one in another, numbers beyond 1e12.
Result<SvgDrawing> read_svg(std::string_view text, const std::string& file, double relative_tolerance);

}  // namespace burin::data
