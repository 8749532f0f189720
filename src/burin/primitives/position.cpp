#include <cmath>

#include <burin/base/math.hpp>
#include <burin/base/random.hpp>
#include <burin/primitives/position.hpp>

namespace burin::primitives {

namespace {

constexpr std::uint64_t chance_purpose = 3;
constexpr std::uint64_t direction_purpose = 4;

Vec2 unit(Vec2 v) {
  const double size = length(v);
  return size > 0.0 ? Vec2{v.x / size, v.y / size} : Vec2{};
}

double degrees(Vec2 v) {
  return math::atan2_degrees(v.y, v.x);
}

}  // namespace

PositionUse used_by(const expr::Expression& expression) {
  PositionUse used;
  if (expression.is_constant()) return used;
  for (std::size_t i = 0; i < used.size(); ++i) used[i] = expression.uses(i);
  return used;
}

Vec2 tangent_of(const Frame& frame) {
  constexpr double vanishing = 1e-9;
  const Vec2 sum = unit(frame.in) + unit(frame.out);
  return length(sum) < vanishing ? frame.out : sum;
}

PositionValues position_values(const Setting& setting, const PathPlace& place, const Frame& frame,
                               const PositionUse& used) {
  const Vec2 point = setting.origin + frame.point;
  const Vec2 p = setting.slot_from_model(point);
  PositionValues values{};
  const auto set = [&](std::size_t variable, auto value) {
    if (used[variable]) values[variable] = value();
  };
  values[position_variable("x")] = point.x;
  values[position_variable("y")] = point.y;
  set(position_variable("r"), [&] { return length(point); });
  set(position_variable("phi"), [&] { return degrees(point); });
  values[position_variable("px")] = p.x;
  values[position_variable("py")] = p.y;
  set(position_variable("pr"), [&] { return length(p); });
  values[position_variable("u")] = 0.5 + p.x / setting.slot_width_mm;
  values[position_variable("v")] = 0.5 + p.y / setting.slot_height_mm;
  values[position_variable("level")] = place.level;
  values[position_variable("index")] = static_cast<double>(frame.index);
  set(position_variable("angle"), [&] { return degrees(frame.out); });
  values[position_variable("i")] = setting.column;
  values[position_variable("j")] = setting.row;
  values[position_variable("copy")] = setting.copy;
  set(position_variable("rand"),
      [&] { return uniform(setting.seed, chance_purpose, place.level, place.path, frame.index); });
  set(position_variable("edge"), [&] { return degrees(frame.out); });
  set(position_variable("tangent"), [&] { return degrees(tangent_of(frame)); });
  set(position_variable("normal"), [&] { return degrees(tangent_of(frame)) - 90.0; });
  set(position_variable("length"),
      [&] { return 0.5 * (length(frame.in) + length(frame.out)) * setting.slot_from_model.scale(); });
  set(position_variable("random"),
      [&] { return 360.0 * uniform(setting.seed, direction_purpose, place.level, place.path, frame.index); });
  return values;
}

}  // namespace burin::primitives
