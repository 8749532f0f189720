#include <initializer_list>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/params/points.hpp>

namespace burin::params {

namespace {

bool read_coordinates(const Value& value, std::string_view expected, std::initializer_list<double*> coordinates,
                      ReadContext& context) {
  const Array* array = value.array();
  if (array == nullptr) return report_kind(value, expected, context);
  if (array->size() != coordinates.size()) {
    context.report(value.where, fmt::format("expected {}, found a list of {}", expected, array->size()));
    return false;
  }
  std::size_t index = 0;
  for (double* coordinate : coordinates) {
    if (!read_number((*array)[index++], *coordinate, context)) return false;
  }
  return true;
}

}  // namespace

bool ValueType<Vec2>::read(const Value& value, Vec2& point, ReadContext& context) {
  return read_coordinates(value, "a point [x, y]", {&point.x, &point.y}, context);
}

std::string ValueType<Vec2>::text(const Vec2& point) {
  return fmt::format("[{}, {}]", shortest_text(point.x), shortest_text(point.y));
}

bool ValueType<Vec3>::read(const Value& value, Vec3& point, ReadContext& context) {
  return read_coordinates(value, "a point [x, y, z]", {&point.x, &point.y, &point.z}, context);
}

std::string ValueType<Vec3>::text(const Vec3& point) {
  return fmt::format("[{}, {}, {}]", shortest_text(point.x), shortest_text(point.y), shortest_text(point.z));
}

}  // namespace burin::params
