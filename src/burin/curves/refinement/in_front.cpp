#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/curves/refinement/in_front.hpp>

namespace burin::curves {

bool check_in_front(double least_depth, const Camera& camera, const Where& where, params::ReadContext& context) {
  if (least_depth >= camera.nearest()) return true;
  if (std::isfinite(least_depth)) {
    context.report(where, fmt::format("the curve may come within {} of the plane through the eye, or behind it; move "
                                      "'eye' farther away from 'target', or use an orthographic camera",
                                      fixed_text(std::max(least_depth, 0.0), 3)));
  } else {
    context.report(where,
                   "nothing is known of how far this curve reaches: it may come behind the eye; use an orthographic "
                   "camera");
  }
  return false;
}

}  // namespace burin::curves
