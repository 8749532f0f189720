#pragma once

#include <span>
#include <vector>

namespace burin::curves::fractal_interpolation {

/// The nearest point to c with sum |c_k| <= radius.
std::vector<double> project_on_l1_ball(std::vector<double> c, double radius);

/// The c that minimises |A c - b|, from gram = A'A (row by row) and moment = A'b. Columns that depend on those before
/// them get 0.
std::vector<double> least_squares(std::span<const double> gram, std::span<const double> moment);

/// The c with sum |c_k| <= radius that minimises |A c - b|: solved freely if that is inside, else by accelerated
/// projected gradients.
std::vector<double> least_squares_within(std::span<const double> gram, std::span<const double> moment, double radius);

}  // namespace burin::curves::fractal_interpolation
