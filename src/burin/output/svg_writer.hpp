#pragma once

#include <memory>

#include <burin/path/back_end.hpp>

namespace burin::output {

/// Half a unit of the last decimal.
double svg_tolerance_mm(const Sheet&, const OutputOptions& options);

/// Looks at `decimals` and at the page's size: above 20 m is refused.
Result<Done> svg_accepts(const Sheet& sheet, const OutputOptions& options);

/// A plotter's SVG, written as the points come in O(1) memory: one top-level group a sheet layer, style on the group,
/// page millimetres, relative commands from rounded positions, so that rounding never adds up. Looks at `decimals` and
/// `paper`.
///
/// A <path> holds whole short strokes up to 1000 segments together. A longer stroke has its own, up to 30,000 segments;
/// then the pen goes on in the next from the same point, which shows only where caps or joins are not round or a dash
/// pattern runs: there a stroke is cut only before its text reaches the 10,000,000 bytes that librsvg reads. A fill has
/// one <path> with all its contours and is never cut. A stroke of one point is a dot. Masks are not drawn.
std::unique_ptr<OutputSink> open_svg(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options);

}  // namespace burin::output
