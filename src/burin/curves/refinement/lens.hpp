#pragma once

#include <burin/curves/refinement/cover.hpp>
#include <burin/geom/camera.hpp>
#include <burin/geom/vec2.hpp>

/// Lenses turn points of a curve into points of the picture. A lens L for points P has
///   Vec2 picture(P) const
///   double picture_radius(P, double radius) const;  of a disc about the picture that holds that of the ball; maybe inf
///   double picture_error(const Cover<P>&) const;    how far the picture of the piece is from that of its chord
namespace burin::curves {

/// A curve of the plane is its own picture; its points are counted from `centre`.
class PlaneLens {
 public:
  explicit PlaneLens(Vec2 centre) : centre_(centre) {}

  Vec2 picture(Vec2 p) const { return p + centre_; }
  double picture_radius(Vec2, double radius) const { return radius; }
  double picture_error(const Cover<Vec2>& cover) const { return cover.error; }

 private:
  Vec2 centre_;
};

/// A curve in space through a camera: its points are counted from `centre`, those of the picture from `origin`.
class SpaceLens {
 public:
  SpaceLens(const Camera& camera, Vec3 centre, Vec2 origin) : camera_(camera), centre_(centre), origin_(origin) {}

  const Camera& camera() const { return camera_; }
  double depth(Vec3 p) const { return camera_.depth(p + centre_); }

  Vec2 picture(Vec3 p) const { return camera_(p + centre_) - origin_; }
  double picture_radius(Vec3 p, double radius) const { return camera_.picture_radius(p + centre_, radius); }
  double picture_error(const Cover<Vec3>& cover) const {
    return camera_.picture_error(cover.a + centre_, cover.b + centre_, cover.radius, cover.error);
  }

 private:
  Camera camera_;
  Vec3 centre_;
  Vec2 origin_;
};

}  // namespace burin::curves
