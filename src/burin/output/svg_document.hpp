#pragma once

#include <cstddef>
#include <string>

#include <burin/path/back_end.hpp>

/// The parts of an SVG file around its paths.
namespace burin::output {

/// Everything before the first layer: root in millimetres, title, description, origin, and the paper when asked for.
/// The origin's record stands in <burin:origin>, written by xml_exact_text().
std::string svg_head(const Sheet& sheet, const OutputOptions& options);

/// The opening tag of a layer, which carries the layer's whole style; `empty` closes it at once.
std::string svg_layer_begin(const Sheet& sheet, std::size_t layer, bool empty);

/// The opening tag of a <path> up to and with the quote that its data follow. A path painted otherwise than its layer
/// says so itself.
std::string svg_path_begin(const Sheet& sheet, const PathHead& head);

}  // namespace burin::output
