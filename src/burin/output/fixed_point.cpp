#include <algorithm>
#include <cstring>

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

char* spell_fixed(char* to, std::int64_t value, int decimals) {
  char digits[24];
  char* const end = digits + sizeof digits;
  char* first = end;
  auto rest = value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
  const auto put = [&](std::uint64_t digit) { *--first = static_cast<char>('0' + digit); };

  bool fraction = false;
  for (int i = 0; i < decimals; ++i, rest /= 10) {
    fraction = fraction || rest % 10 != 0;
    if (fraction) put(rest % 10);
  }
  if (fraction) *--first = '.';
  if (rest == 0 && !fraction) put(0);
  for (; rest > 0; rest /= 10) put(rest % 10);
  if (value < 0) *--first = '-';

  const auto length = static_cast<std::size_t>(end - first);
  std::memcpy(to, first, length);
  return to + length;
}

double half_unit_mm(int decimals) {
  return 0.5 / units_per_mm(decimals);
}

}  // namespace burin::output
