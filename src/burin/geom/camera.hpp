#pragma once

#include <cstdint>
#include <limits>

#include <burin/geom/vec2.hpp>
#include <burin/geom/vec3.hpp>

namespace burin {

enum class Projection : std::uint8_t { orthographic, perspective };

/// Where a camera stands and what it looks at.
struct CameraPose {
  Projection projection = Projection::orthographic;
  Vec3 eye{4.0, -6.0, 3.0};
  Vec3 target{};
  Vec3 up{0.0, 0.0, 1.0};  ///< up in the picture; seen along it, y is
  double scale = 1.0;      ///< units of the picture in a unit of space at the target
};

/// Maps space to a picture, x right and y up, in which straight lines stay straight. The picture of the target is the
/// origin. In perspective a point has a picture only in front of the eye: at depths of `nearest()` and more.
class Camera {
 public:
  /// Pre: eye and target differ; scale > 0.
  explicit Camera(const CameraPose& pose);

  bool is_perspective() const { return pose_.projection == Projection::perspective; }
  /// Pre: depth(p) >= nearest().
  Vec2 operator()(Vec3 p) const;
  /// How far beyond the plane through the eye that is across the line of sight.
  double depth(Vec3 p) const { return dot(forward_, p - pose_.eye); }
  /// From eye to target.
  double distance() const { return distance_; }
  /// The least depth that has a picture: a thousandth of the distance; orthographic: any.
  double nearest() const { return is_perspective() ? 1e-3 * distance_ : -std::numeric_limits<double>::infinity(); }

  /// The radius of a disc about the picture of p that holds the picture of the ball about p; infinite if that is not
  /// all in front.
  double picture_radius(Vec3 p, double radius) const;
  /// How far the picture of a point may lie from that of a segment it is within `error` of, when both are within
  /// `radius` of the segment ab; infinite if that is not all in front.
  double picture_error(Vec3 a, Vec3 b, double radius, double error) const;

 private:
  CameraPose pose_;
  Vec3 right_;
  Vec3 up_;
  Vec3 forward_;
  double distance_;
  double factor_;  ///< picture = factor * (right, up), in perspective over the depth
};

}  // namespace burin
