#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/preset/symmetry.hpp>

namespace burin::preset {
namespace {

constexpr double side = 20.0;

Vec2 random_point(const Box2& box, std::uint64_t seed) {
  return {box.low.x + uniform(seed, 1) * box.width(), box.low.y + uniform(seed, 2) * box.height()};
}

bool is_isometry(const Affine2& m) {
  return std::abs(m.a * m.a + m.b * m.b - 1) < 1e-12 && std::abs(m.c * m.c + m.d * m.d - 1) < 1e-12 &&
         std::abs(m.a * m.c + m.b * m.d) < 1e-12;
}

TEST(Symmetry, RosettesAreGroups) {
  for (const auto& [name, order] :
       {std::pair{"c1", 1U}, {"c6", 6U}, {"c7", 7U}, {"d1", 2U}, {"d6", 12U}, {"c360", 360U}}) {
    const std::vector<Affine2> maps = *rosette(name);
    ASSERT_EQ(maps.size(), order) << name;
    EXPECT_EQ(maps.front(), Affine2{});
    const Vec2 p{0.3, 1.1};
    for (const Affine2& f : maps) {
      EXPECT_TRUE(is_isometry(f));
      for (const Affine2& g : maps) {
        const bool member =
            std::any_of(maps.begin(), maps.end(), [&](const Affine2& h) { return distance(h(p), f(g(p))) < 1e-9; });
        ASSERT_TRUE(member) << name;
      }
    }
  }
  for (const char* name : {"", "c", "c0", "c361", "d-1", "c6x", "e6", "p4m", "c99999999999"})
    EXPECT_FALSE(rosette(name)) << name;
}

TEST(Symmetry, TilingsHaveTheirGroupsOrderInEveryCell) {
  const std::pair<const char*, std::size_t> orders[] = {
      {"p111", 1}, {"p1a1", 2}, {"p1m1", 2}, {"pm11", 2}, {"p112", 2}, {"pma2", 4}, {"pmm2", 4}, {"p1", 1},  {"p2", 2},
      {"pm", 2},   {"pg", 2},   {"pmm", 4},  {"p4", 4},   {"p4m", 8},  {"p3", 3},   {"p6", 6},   {"p6m", 12}};
  EXPECT_EQ(tiling_names().size(), std::size(orders));
  for (const auto& [name, order] : orders) {
    EXPECT_TRUE(is_symmetry(name));
    const bool frieze = std::string(name).size() == 4;
    const std::optional<Tiling> tiling = tile(name, 5 * side, 5 * side, side);
    ASSERT_TRUE(tiling) << name;
    if (name[1] != '3' && name[1] != '6') {
      EXPECT_EQ(tiling->copies.size(), order * (frieze ? 5 : 25)) << name;
    }
    EXPECT_EQ(tiling->copies.size() % order, 0U) << name;
    EXPECT_FALSE(tiling->domain.empty()) << name;
    for (const Affine2& copy : tiling->copies) EXPECT_TRUE(is_isometry(copy)) << name;
  }
}

TEST(Symmetry, CopiesOfTheDomainNeitherOverlapNorLeaveTheRectangle) {
  for (const std::string_view name : tiling_names()) {
    const Tiling tiling = *tile(name, 4 * side, 3.7 * side, side);
    ASSERT_GT(tiling.copies.size(), 1U) << name;
    const Box2 rectangle{{-2 * side, -1.85 * side}, {2 * side, 1.85 * side}};
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Vec2 p = random_point(tiling.domain, seed);
      std::vector<Vec2> back;
      for (const Affine2& copy : tiling.copies) {
        EXPECT_TRUE(rectangle.grown(1e-9).contains(copy(p))) << name;
        // Seen from the first copy, no other copy of the domain covers its inside.
        const Vec2 seen = inverse(tiling.copies.front())(copy(p));
        const bool same = distance(seen, p) < 1e-9;
        EXPECT_TRUE(same || !tiling.domain.grown(-1e-9).contains(seen)) << name;
      }
    }
  }
}

TEST(Symmetry, AWallpaperIsInvariantUnderItsOwnMaps) {
  // Each map that carries one copy to another of the same cell carries every copy onto a copy, away from the rim.
  for (const std::string_view name : tiling_names()) {
    const Tiling tiling = *tile(name, 9 * side, 9 * side, side);
    const Vec2 p = random_point(tiling.domain, 3);
    std::vector<Vec2> orbit;
    for (const Affine2& copy : tiling.copies) orbit.push_back(copy(p));
    const Affine2 middle = tiling.copies[tiling.copies.size() / 2];
    for (std::size_t c = 0; c < tiling.copies.size(); ++c) {
      const Affine2 map = tiling.copies[c] * inverse(middle);
      if (length(map(Vec2{})) > 1.5 * side) continue;
      for (const Vec2 q : orbit) {
        const Vec2 image = map(q);
        if (std::abs(image.x) > 2.4 * side || std::abs(image.y) > 2.4 * side) continue;
        const bool member = std::any_of(orbit.begin(), orbit.end(), [&](Vec2 o) { return distance(o, image) < 1e-6; });
        ASSERT_TRUE(member) << name << ' ' << c;
      }
    }
  }
}

TEST(Symmetry, TooSmallARectangleHoldsNothing) {
  EXPECT_TRUE(tile("p4m", 10, 30, 20)->copies.empty());
  EXPECT_TRUE(tile("p6", 10, 10, 20)->copies.empty());
  EXPECT_EQ(tile("p1", 100, 100, 10)->copies.size(), 100U);
  EXPECT_FALSE(tile("p5", 10, 10, 1));
}

}  // namespace
}  // namespace burin::preset
