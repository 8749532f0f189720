#pragma once

#include <span>
#include <string_view>

#include <burin/base/bytes.hpp>
#include <burin/primitives/primitive.hpp>

namespace burin::primitives {

/// A figure that comes with burin: its name and its SVG.
struct ShippedFigure {
  std::string_view name;
  std::string_view svg;
};

/// The figures of primitives/, by name.
std::span<const ShippedFigure> shipped_figures();

/// What a ReadFile is asked for when a figure of the user's own library is meant: this and "NAME.svg". Whoever gives
/// the ReadFile decides where that library is; the tool looks into $XDG_DATA_HOME/burin/primitives.
inline constexpr std::string_view personal_prefix = "burin:primitives/";

/// The figure that a preset calls `word`: a file, relative to the preset, when the word has a '/' or ends in ".svg";
/// else a shipped figure, else one of the user's own library. Problems: no such figure, with the nearest name; those of
/// read_primitive_svg.
Result<Primitive> find_primitive(std::string_view word, const ReadFile& read_file, double tolerance = figure_tolerance);

}  // namespace burin::primitives
