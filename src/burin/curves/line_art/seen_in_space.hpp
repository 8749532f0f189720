#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <burin/geom/box2.hpp>
#include <burin/geom/camera.hpp>

namespace burin::curves::line_art {

/// Everything within `radius` of the centre.
struct Ball {
  Vec3 centre;
  double radius = 0.0;
};

/// A box of the picture of a ball; everything if the ball is not all in front of the eye.
inline Box2 picture_of(const Camera& camera, const Ball& ball) {
  const double radius = camera.picture_radius(ball.centre, ball.radius);
  if (!std::isfinite(radius)) return Box2::everything();
  const Vec2 centre = camera(ball.centre);
  return Box2{centre, centre}.grown(radius);
}

/// Whether a box is that of a ball which is not all in front.
inline bool is_unbounded(const Box2& box) {
  return !std::isfinite(box.low.x);
}

/// The picture of a polyline up to where it comes behind the eye, with at least one point. The depth of the middle of
/// its chord, beyond the camera's target.
inline double show(const Camera& camera, const std::vector<Vec3>& polyline, std::vector<Vec2>& picture) {
  picture.clear();
  std::size_t shown = 0;
  while (shown < polyline.size() && camera.depth(polyline[shown]) >= camera.nearest()) {
    picture.push_back(camera(polyline[shown]));
    ++shown;
  }
  const double depth = camera.depth(0.5 * (polyline.front() + polyline[shown == 0 ? 0 : shown - 1]));
  return depth - camera.distance();
}

}  // namespace burin::curves::line_art
