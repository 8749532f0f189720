#pragma once

#include <string>

#include <burin/measure/box_dimension.hpp>
#include <burin/path/path_sink.hpp>
#include <burin/path/sheet.hpp>

namespace burin::cli {

/// The page and pens of a plot of box counts.
Sheet box_plot_sheet(const std::string& title);

/// Draws log2 of the counts against log2 of the boxes to the longer side, the fitted line and its slope, in the
/// millimetres of that page. Pre: at least two scales.
[[nodiscard]] Flow draw_box_plot(const measure::BoxDimension& fit, const std::string& title, PathSink& sink);

}  // namespace burin::cli
