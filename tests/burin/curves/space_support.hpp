#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/random.hpp>
#include <burin/geom/vec3.hpp>

#include "support/curve_summary.hpp"
#include "support/json_value.hpp"

namespace burin::testing {

/// The points of a curve in space: what is seen from above and what is seen from the front, put together.
inline std::vector<Vec3> space_points(std::string_view family, nlohmann::json params, std::uint64_t seed = 0) {
  params["camera"] = {{"eye", {0, 0, 1}}};
  const std::vector<Vec2> above = draw_points(family, params, {.seed = seed});
  params["camera"] = {{"eye", {0, -1, 0}}};
  const std::vector<Vec2> front = draw_points(family, params, {.seed = seed});
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < above.size() && i < front.size(); ++i) {
    EXPECT_NEAR(above[i].x, front[i].x, 1e-12 * (1 + std::abs(above[i].x)));
    points.push_back({above[i].x, above[i].y, front[i].y});
  }
  EXPECT_EQ(above.size(), front.size());
  return points;
}

inline nlohmann::json json_points(const std::vector<Vec3>& points) {
  nlohmann::json list = nlohmann::json::array();
  for (const Vec3 p : points) list.push_back({p.x, p.y, p.z});
  return list;
}

inline std::vector<Vec3> random_space_points(std::uint64_t seed, std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(
        {2 * uniform_symmetric(seed, i, 1), 2 * uniform_symmetric(seed, i, 2), 2 * uniform_symmetric(seed, i, 3)});
  }
  return points;
}

inline void expect_near(Vec3 p, Vec3 expected, double tolerance) {
  EXPECT_NEAR(p.x, expected.x, tolerance);
  EXPECT_NEAR(p.y, expected.y, tolerance);
  EXPECT_NEAR(p.z, expected.z, tolerance);
}

}  // namespace burin::testing
