#pragma once

#include <cstdint>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/path/recording.hpp>

/// Counting the boxes of a grid that a curve meets, at several sizes of boxes (reference interpolation 6).
namespace burin::measure {

/// How many cells floor((p - origin) / side) the drawing passes through: every edge is cut at the grid lines that it
/// crosses, and the middle of each part says which cell it lies in. Edges of length 0 are passed over.
/// Time: edges and crossings. Memory: a bit for each cell of the bounding box. Pre: side > 0, at most 2^30 such cells.
std::uint64_t box_count(const Recording& drawing, double side, Vec2 origin);

struct BoxScale {
  double side = 0.0;
  double count = 0.0;  ///< the mean over several positions of the grid
};

/// log(count) against log(1 / side), fitted by a line.
struct BoxDimension {
  double dimension = 0.0;       ///< the line's slope
  double standard_error = 0.0;  ///< of the slope
  double r_squared = 0.0;
  double intercept = 0.0;          ///< natural logarithms
  std::vector<BoxScale> scales{};  ///< from the largest boxes
  double extent = 0.0;             ///< the longer side of the drawing, the width of a graph
  bool is_of_graph = false;        ///< the counts are of columns, see graph_scales
  bool is_of_few_edges = false;    ///< boxes are smaller than the edges: they see the polyline, not what it stands for
};

/// A graph of a function is counted by graph_scales. Else: boxes from 1/8 of the drawing's longer side, each 1/sqrt(2)
/// of the one before, down to 1/256 or to twice the median edge, below which a polyline shows its straight edges; where
/// that leaves fewer than three sizes, down to 1/256. A problem when the drawing has no extent.
Result<BoxDimension> box_dimension(const Recording& drawing);

}  // namespace burin::measure
