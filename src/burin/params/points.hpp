#pragma once

#include <string>

#include <burin/geom/vec2.hpp>
#include <burin/geom/vec3.hpp>
#include <burin/params/read_value.hpp>

namespace burin::params {

/// A point [x, y] of numbers or constant expressions.
template <>
struct ValueType<Vec2> {
  static std::string name() { return "point"; }
  static bool read(const Value& value, Vec2& point, ReadContext& context);
  static std::string text(const Vec2& point);
};

/// A point of space [x, y, z].
template <>
struct ValueType<Vec3> {
  static std::string name() { return "point of space"; }
  static bool read(const Value& value, Vec3& point, ReadContext& context);
  static std::string text(const Vec3& point);
};

}  // namespace burin::params
