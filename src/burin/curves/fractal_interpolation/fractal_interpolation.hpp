#pragma once

#include <burin/curves/family.hpp>

namespace burin::curves {

/// The family's row in the catalogue.
Family fractal_interpolation_family();

}  // namespace burin::curves
