#pragma once

#include <array>
#include <optional>
#include <string>

#include <burin/geom/camera.hpp>
#include <burin/params/fields.hpp>
#include <burin/params/points.hpp>

namespace burin {

constexpr auto words(Projection) {
  return std::array<params::Word<Projection>, 2>{
      {{"orthographic", Projection::orthographic}, {"perspective", Projection::perspective}}};
}

}  // namespace burin

namespace burin::params {

/// How everything in space is seen: one declaration for all families and forms.
struct CameraParams {
  Projection projection = Projection::orthographic;
  Vec3 eye = CameraPose{}.eye;
  Vec3 target{};
  Vec3 up = CameraPose{}.up;
  std::optional<double> fov;
  std::optional<double> scale;

  static constexpr auto fields() {
    return std::tuple{
        field("projection", &CameraParams::projection,
              "orthographic: parallel lines stay parallel; perspective: what is far away is small"),
        field("eye", &CameraParams::eye, "where the camera stands; orthographic: only its direction counts"),
        field("target", &CameraParams::target, "what it looks at: the origin of the picture"),
        field("up", &CameraParams::up, "what is up in the picture; when that is along the line of sight, y is"),
        field("fov", &CameraParams::fov, {0.0, 180.0, true, true},
              "of perspective, instead of `scale`: the angle in degrees that one unit of the picture is high"),
        field("scale", &CameraParams::scale, positive,
              "units of the picture in a unit of space at the target; unset: 1; matters where a slot has a scale or a "
              "frame")};
  }

  Camera camera() const;
};
static_assert(ParamStruct<CameraParams>);

/// A table, or the name of one in [define].
template <>
struct ValueType<CameraParams> {
  static std::string name() { return "camera"; }
  static bool read(const Value& value, CameraParams& camera, ReadContext& context);
  static std::string text(const CameraParams&) { return {}; }
};

}  // namespace burin::params
