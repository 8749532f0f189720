#pragma once

#include <burin/path/back_end.hpp>

namespace burin::output_cairo {

/// SVG as Cairo writes it: in millimetres, snapped to 1/256 mm, without layers. The native writer is better for
/// plotters and editors. Looks at OutputOptions::paper. Memory: Cairo keeps the page until finish().
BackEnd svg_back_end();

}  // namespace burin::output_cairo
