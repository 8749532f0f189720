#pragma once

#include <burin/base/math.hpp>
#include <burin/geom/vec2.hpp>

namespace burin {

/// The unit vector at an angle from the x axis.
inline Vec2 direction(double radians) {
  const math::CosineSine both = math::cos_sin(radians);
  return {both.cosine, both.sine};
}

}  // namespace burin
