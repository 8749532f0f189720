#pragma once

#include <vector>

#include <burin/measure/box_dimension.hpp>

namespace burin::measure {

/// The boxes that the graph of a function meets, column by column: in each column of the width of a box its oscillation
/// over the height of a box, not rounded up to whole boxes. The sum grows with the box dimension like the count does,
/// and comes to it much sooner (Dubuc et al. 1989; reference interpolation 6). Columns of 8 samples in the mean at
/// every width, so that what the samples miss is the same share everywhere: five widths, each half of the one before.
///
/// Empty when the drawing is no graph of at least 1024 edges (one open contour whose x never turns), or one of a
/// constant. O(points).
std::vector<BoxScale> graph_scales(const Recording& drawing);

}  // namespace burin::measure
