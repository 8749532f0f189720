#include <burin/curves/fractal_interpolation/enclosures.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

constexpr std::size_t most_cells = 8192;

/// What the map of a piece needs to know over one cell: phi there becomes s (phi - B) + P.
struct CellMap {
  Interval scaling;
  Interval whole;
  Interval own;

  Interval operator()(Interval phi) const { return scaling * (phi - whole) + own; }
};

/// For each piece in turn, each cell of a depth.
std::vector<CellMap> cell_maps(const Interpolant& f, const std::vector<double>& ends) {
  std::vector<CellMap> maps;
  for (const Piece& piece : f.pieces) {
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const Interval over{ends[k], ends[k + 1]};
      maps.push_back({scaling_range(piece.scaling, over), value_range(f.whole, piece.shape, over),
                      value_range(piece.ends, piece.shape, over)});
    }
  }
  return maps;
}

/// The ranges of the cells one level up: each holds those of its children.
std::vector<Interval> merged(const std::vector<Interval>& children, std::size_t of_each) {
  std::vector<Interval> parents;
  for (std::size_t first = 0; first < children.size(); first += of_each) {
    Interval range = children[first];
    for (std::size_t k = first + 1; k < first + of_each; ++k) range = hull(range, children[k]);
    parents.push_back(range);
  }
  return parents;
}

}  // namespace

std::vector<double> cell_ends(const Interpolant& f, std::size_t depth) {
  std::vector<double> ends{0.0, 1.0};
  for (std::size_t d = 0; d < depth; ++d) {
    std::vector<double> finer;
    for (const Piece& piece : f.pieces) {
      for (std::size_t k = 0; k + 1 < ends.size(); ++k) finer.push_back(piece.start + piece.width * ends[k]);
    }
    finer.push_back(1.0);
    ends = std::move(finer);
  }
  return ends;
}

Enclosures make_enclosures(const Interpolant& f) {
  const std::size_t n = f.pieces.size();
  std::size_t depth = 1;
  std::size_t cells = n;
  while (cells * n <= most_cells && n > 1) {
    cells *= n;
    ++depth;
  }
  const std::vector<CellMap> maps = cell_maps(f, cell_ends(f, depth - 1));
  const Spans span = spans(f);
  const double reach = f.gap + span.own;
  // |phi - middle| <= |P - middle| + |phi - P|; from there each round tightens what the last one gave.
  std::vector<Interval> coarse(cells / n, {span.middle - reach, span.middle + reach});
  std::vector<Interval> fine(cells);
  constexpr int most_rounds = 100;
  for (int round = 0; round < most_rounds; ++round) {
    for (std::size_t i = 0; i < cells; ++i) fine[i] = maps[i](coarse[i % coarse.size()]);
    std::vector<Interval> tighter = merged(fine, n);
    double gained = 0.0;
    for (std::size_t k = 0; k < coarse.size(); ++k) {
      gained = std::max(gained, coarse[k].width() - tighter[k].width());
      coarse[k] = common(coarse[k], tighter[k]);
    }
    if (gained <= 1e-6 * reach) break;
  }
  // Rounding may have taken a little off.
  const double slack = 1e-14 * (reach + std::abs(span.middle));
  for (Interval& range : fine) range = {range.low - slack, range.high + slack};
  Enclosures result{{}, stretches(f)};
  result.by_depth.resize(depth + 1);
  result.by_depth[depth] = std::move(fine);
  for (std::size_t d = depth; d > 0; --d) result.by_depth[d - 1] = merged(result.by_depth[d], n);
  return result;
}

GraphPoint cell_left(const Interpolant& f, std::span<const std::uint32_t> digits) {
  if (digits.empty()) return node_point(f, 0);
  // A map takes the first node to its interval's left one, to the bit.
  return point_at(f, digits.first(digits.size() - 1), digits.back());
}

CellBox cell_box(const Interpolant& f, const Enclosures& enclosures, std::span<const std::uint32_t> digits) {
  const std::size_t known = std::min(digits.size(), enclosures.depth());
  std::size_t outer = digits.size() - known;
  std::size_t index = 0;
  CellBox box;
  for (const std::uint32_t digit : digits.subspan(outer)) {
    index = index * f.pieces.size() + digit;
    box.width *= f.pieces[digit].width;
  }
  box.left = cell_left(f, digits.subspan(outer));
  box.range = enclosures.by_depth[known][index];
  double reach = box.range.reach_from(box.left.y);
  for (; outer > 0; --outer) {
    const std::uint32_t digit = digits[outer - 1];
    const Piece& piece = f.pieces[digit];
    const Stretch& stretch = enclosures.stretches[digit];
    const double distance = std::abs(box.left.y - whole_cubic(f, piece, box.left.theta));
    reach = stretch.scaling * reach +
            box.width * (stretch.scaling_slope * distance + stretch.scaling * stretch.whole_slope + stretch.own_slope);
    box.left = mapped(f, piece, box.left);
    box.width *= piece.width;
    box.range = {box.left.y - reach, box.left.y + reach};
  }
  return box;
}

}  // namespace burin::curves::fractal_interpolation
