#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include <burin/preset/symmetry.hpp>

namespace burin::preset {

namespace {

constexpr double sqrt3 = 1.73205080756887729353;

constexpr Affine2 identity{};
/// The half turn about (x, y).
constexpr Affine2 half_turn(double x, double y) {
  return {-1.0, 0.0, 0.0, -1.0, 2.0 * x, 2.0 * y};
}
/// The reflection in the upright line at x, and in the level line at y.
constexpr Affine2 mirror_x(double x) {
  return {-1.0, 0.0, 0.0, 1.0, 2.0 * x, 0.0};
}
constexpr Affine2 mirror_y(double y) {
  return {1.0, 0.0, 0.0, -1.0, 0.0, 2.0 * y};
}
/// The glide by half a cell along the level line at y.
constexpr Affine2 glide(double y) {
  return {1.0, 0.0, 0.0, -1.0, 0.5, 2.0 * y};
}

/// Turns by multiples of 360/n degrees about `centre`, each also after `mirror` when there is one.
std::vector<Affine2> turns(int n, Vec2 centre, const Affine2* mirror) {
  std::vector<Affine2> maps;
  for (int i = 0; i < n; ++i) {
    const Affine2 turn = translation(centre) * rotation_degrees(360.0 * i / n) * translation(-centre);
    maps.push_back(turn);
    if (mirror != nullptr) maps.push_back(turn * *mirror);
  }
  return maps;
}

enum class Lattice { frieze, square, hexagonal };

/// A group in cells of side 1; a frieze's cell is `height` high. The domain is a rectangle inside a fundamental region.
struct Group {
  std::string_view name;
  Lattice lattice;
  Box2 (*domain)(double height);
  std::vector<Affine2> (*maps)(double height);
};

constexpr Box2 box(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y + height}};
}

/// The diagonal swap x <-> y.
constexpr Affine2 diagonal{0.0, 1.0, 1.0, 0.0, 0.0, 0.0};
constexpr Affine2 upright = mirror_x(0.0);

const std::array<Group, 17>& groups() {
  using Maps = std::vector<Affine2>;
  static const std::array<Group, 17> rows{{
      {"p111", Lattice::frieze, [](double h) { return box(0, 0, 1, h); }, [](double) { return Maps{identity}; }},
      {"p1a1", Lattice::frieze, [](double h) { return box(0, 0, 0.5, h); },
       [](double h) {
         return Maps{identity, glide(h / 2)};
       }},
      {"p1m1", Lattice::frieze, [](double h) { return box(0, 0, 1, h / 2); },
       [](double h) {
         return Maps{identity, mirror_y(h / 2)};
       }},
      {"pm11", Lattice::frieze, [](double h) { return box(0, 0, 0.5, h); },
       [](double) {
         return Maps{identity, mirror_x(0.5)};
       }},
      {"p112", Lattice::frieze, [](double h) { return box(0, 0, 0.5, h); },
       [](double h) {
         return Maps{identity, half_turn(0.5, h / 2)};
       }},
      {"pma2", Lattice::frieze, [](double h) { return box(0, 0, 0.25, h); },
       [](double h) {
         return Maps{identity, mirror_x(0.25), glide(h / 2), half_turn(0.5, h / 2)};
       }},
      {"pmm2", Lattice::frieze, [](double h) { return box(0, 0, 0.5, h / 2); },
       [](double h) {
         return Maps{identity, mirror_x(0.5), mirror_y(h / 2), half_turn(0.5, h / 2)};
       }},
      {"p1", Lattice::square, [](double) { return box(0, 0, 1, 1); }, [](double) { return Maps{identity}; }},
      {"p2", Lattice::square, [](double) { return box(0, 0, 1, 0.5); },
       [](double) {
         return Maps{identity, half_turn(0.5, 0.5)};
       }},
      {"pm", Lattice::square, [](double) { return box(0, 0, 0.5, 1); },
       [](double) {
         return Maps{identity, mirror_x(0.5)};
       }},
      {"pg", Lattice::square, [](double) { return box(0, 0, 0.5, 1); },
       [](double) {
         return Maps{identity, glide(0.5)};
       }},
      {"pmm", Lattice::square, [](double) { return box(0, 0, 0.5, 0.5); },
       [](double) {
         return Maps{identity, mirror_x(0.5), mirror_y(0.5), half_turn(0.5, 0.5)};
       }},
      {"p4", Lattice::square, [](double) { return box(0, 0, 0.5, 0.5); },
       [](double) {
         return turns(4, {0.5, 0.5}, nullptr);
       }},
      {"p4m", Lattice::square, [](double) { return box(0.25, 0, 0.25, 0.25); },
       [](double) {
         return turns(4, {0.5, 0.5}, &diagonal);
       }},
      // A hexagonal cell is the hexagon of width 1 about a lattice point; the domains lie above that point.
      {"p3", Lattice::hexagonal, [](double) { return box(-0.25, sqrt3 / 12, 0.5, sqrt3 / 6); },
       [](double) { return turns(3, {}, nullptr); }},
      {"p6", Lattice::hexagonal, [](double) { return box(-0.144, 0.25, 0.288, 0.243); },
       [](double) { return turns(6, {}, nullptr); }},
      {"p6m", Lattice::hexagonal, [](double) { return box(0, sqrt3 / 8, 0.125, sqrt3 / 6); },
       [](double) { return turns(6, {}, &upright); }},
  }};
  return rows;
}

/// Where cells lie, in cell sides about the middle of a width x height rectangle (in cell sides as well).
std::vector<Vec2> cell_places(Lattice lattice, double width, double height) {
  // A hair of tolerance: 100 mm hold ten cells of 10 mm whatever the rounding.
  constexpr double hair = 1e-9;
  std::vector<Vec2> places;
  if (lattice == Lattice::hexagonal) {
    const auto rows = static_cast<int>(std::floor((height - 2.0 / sqrt3 + hair) / (sqrt3 / 2.0))) + 1;
    for (int row = 0; row < rows; ++row) {
      const double y = (row - 0.5 * (rows - 1)) * sqrt3 / 2.0;
      const double shift = row % 2 == 0 ? 0.0 : 0.5;
      const auto columns = static_cast<int>(std::floor(width - 2.0 * shift + hair));
      for (int column = 0; column < columns; ++column) places.push_back({column - 0.5 * (columns - 1), y});
    }
    return places;
  }
  const auto columns = static_cast<int>(std::floor(width + hair));
  const auto rows = lattice == Lattice::frieze ? 1 : static_cast<int>(std::floor(height + hair));
  const double cell_height = lattice == Lattice::frieze ? height : 1.0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      places.push_back({column - 0.5 * columns, (row - 0.5 * rows) * cell_height});
    }
  }
  return places;
}

}  // namespace

std::optional<std::vector<Affine2>> rosette(std::string_view name) {
  if (name.size() < 2 || (name[0] != 'c' && name[0] != 'd')) return std::nullopt;
  int n = 0;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), n);
  if (error != std::errc{} || end != name.data() + name.size() || n < 1 || n > 360) return std::nullopt;
  return turns(n, {}, name[0] == 'd' ? &upright : nullptr);
}

std::optional<Tiling> tile(std::string_view name, double width_mm, double height_mm, double cell_mm) {
  const auto group = std::find_if(groups().begin(), groups().end(), [&](const Group& g) { return g.name == name; });
  if (group == groups().end()) return std::nullopt;
  const double height = height_mm / cell_mm;
  const Affine2 mm_from_cell = scaling(cell_mm, cell_mm);
  const Affine2 cell_from_mm = scaling(1.0 / cell_mm, 1.0 / cell_mm);
  Tiling tiling{image_box(mm_from_cell, group->domain(height)), {}};
  for (const Vec2 place : cell_places(group->lattice, width_mm / cell_mm, height)) {
    for (const Affine2& map : group->maps(height)) {
      tiling.copies.push_back(mm_from_cell * translation(place) * map * cell_from_mm);
    }
  }
  return tiling;
}

bool is_symmetry(std::string_view name) {
  const std::vector<std::string_view> tilings = tiling_names();
  return rosette(name).has_value() || std::find(tilings.begin(), tilings.end(), name) != tilings.end();
}

std::vector<std::string_view> tiling_names() {
  std::vector<std::string_view> names;
  for (const Group& group : groups()) names.push_back(group.name);
  return names;
}

}  // namespace burin::preset
