#include <algorithm>

#include <burin/base/check.hpp>
#include <burin/output/fixed_point.hpp>

namespace burin::output {

namespace {

constexpr std::array<double, 7> powers_of_ten{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};

double units_per_mm(int decimals) {
  BURIN_EXPECT(decimals >= 0 && decimals < static_cast<int>(powers_of_ten.size()));
  return powers_of_ten[static_cast<std::size_t>(decimals)];
}

}  // namespace

bool can_be_rounded(std::span<const Vec2> points) {
  return std::ranges::all_of(
      points, [](Vec2 p) { return std::abs(p.x) < coordinate_limit_mm && std::abs(p.y) < coordinate_limit_mm; });
}

Problem coordinate_problem() {
  return {{},
          "a point lies more than a thousand kilometres from the page, which no coordinate can say: draw at a smaller "
          "scale or crop the drawing",
          Trouble::limit};
}

Grid::Grid(int decimals) : decimals_(decimals), units_per_mm_(units_per_mm(decimals)) {}

double half_unit_mm(int decimals) {
  return 0.5 / units_per_mm(decimals);
}

}  // namespace burin::output
