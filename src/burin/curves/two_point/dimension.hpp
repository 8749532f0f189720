#pragma once

#include <optional>
#include <vector>

#include <burin/curves/two_point/motif.hpp>

namespace burin::curves::two_point {

/// Lengths of the sub-edges on a unit edge. Pre: the marks are constant.
std::vector<double> edge_ratios(const std::vector<Mark>& marks);

/// D with sum |r_j|^D = 1: the Hausdorff dimension of the curve when its copies do not overlap essentially. Nothing
/// when the motif is not the same on every edge and level, or when an edge is not shorter than the whole.
/// Source: Moran 1946; Hutchinson 1981.
std::optional<double> similarity_dimension(const Motif& motif);

}  // namespace burin::curves::two_point
