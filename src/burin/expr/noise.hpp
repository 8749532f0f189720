#pragma once

namespace burin::expr {

/// Smooth noise of the plane in [-1, 1]: gradient noise (Perlin 2002) on the integer lattice, twice continuously
/// differentiable, 0 at lattice points, the same function in every run. Bumps are about one unit apart; scale the
/// arguments for coarser or finer ones. 0 beyond +-2^52, where doubles are lattice points only; NaN for NaN.
double noise(double x, double y);

}  // namespace burin::expr
