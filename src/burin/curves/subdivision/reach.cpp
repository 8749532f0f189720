#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <burin/curves/subdivision/reach.hpp>

namespace burin::curves::subdivision {

namespace {

/// The longest words of halvings that are looked at one by one.
constexpr std::size_t longest_word = 6;

/// Room for rounding in the tables.
constexpr double safety = 1.0 + 1e-9;

/// A row of weights on the points of a window.
using Functional = std::vector<double>;

/// What a word of halvings does: how far the descendant lies from where it is expected, and how much its differences
/// have grown, both at worst and in differences of the window.
struct Word {
  double away = 0.0;
  double growth = 0.0;
};
using WordsByLength = std::array<std::vector<Word>, longest_word + 1>;

/// The larger of two bounds; what is no number counts as beyond all numbers.
double larger(double a, double b) {
  if (std::isnan(b)) return std::numeric_limits<double>::infinity();
  return std::max(a, b);
}

Matrix identity(std::size_t size) {
  Matrix one(size);
  for (std::size_t i = 0; i < size; ++i) one.at(i, i) = 1.0;
  return one;
}

Functional row_of(const Matrix& matrix, std::size_t row) {
  const auto first = matrix.entries.begin() + static_cast<std::ptrdiff_t>(row * matrix.size);
  return {first, first + static_cast<std::ptrdiff_t>(matrix.size)};
}

/// a + factor * b
Functional plus(Functional a, double factor, const Functional& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
  return a;
}

/// The largest value of a functional over windows whose differences of this order are at most 1. Pre: it is 0 on
/// constants (order 1), on equally spaced points of a line too (order 2).
double norm_in_differences(Functional f, int order) {
  // Summation by parts: the weights of the differences are sums of the weights of the points.
  for (int step = 0; step < order; ++step) {
    for (std::size_t i = 1; i < f.size(); ++i) f[i] += f[i - 1];
    f.pop_back();
  }
  double norm = 0.0;
  for (const double weight : f) norm += std::abs(weight);
  return norm;
}

/// How much differences of this order grow along a word at most.
double growth_of(const Matrix& word, int order) {
  std::vector<Functional> rows;
  for (std::size_t row = 0; row < word.size; ++row) rows.push_back(row_of(word, row));
  for (int step = 0; step < order; ++step) {
    for (std::size_t row = 0; row + 1 < rows.size(); ++row) rows[row] = plus(rows[row + 1], -1.0, rows[row]);
    rows.pop_back();
  }
  double growth = 0.0;
  for (const Functional& row : rows) growth = larger(growth, norm_in_differences(row, order));
  return growth;
}

/// Calls visit(length, product) for every word of up to longest_word halvings.
template <class Visit>
void for_each_word(const WindowMaps& maps, std::size_t ends, const Matrix& word, std::size_t length,
                   const Visit& visit) {
  if (length > 0) visit(length, word);
  if (length == longest_word) return;
  const WindowMaps::Halves& halves = maps.by_ends[ends];
  for_each_word(maps, ends & 1U, product(halves.left, word), length + 1, visit);
  for_each_word(maps, ends & 2U, product(halves.right, word), length + 1, visit);
}

/// How far points are away after 0, 1, ... levels, `at_last` being how far they are in the last piece itself.
std::vector<double> table_of(const WordsByLength& words, double at_last, int levels) {
  std::vector<double> table{at_last};
  for (std::size_t k = 1; k <= static_cast<std::size_t>(levels); ++k) {
    const std::size_t length = std::min(k, longest_word);
    double farthest = 0.0;
    for (const Word& word : words[length]) {
      farthest = larger(farthest, word.away + scaled(table[k - length], word.growth));
    }
    table.push_back(farthest);
  }
  for (double& entry : table) entry *= safety;
  return table;
}

/// From the middle between the window's start and the point after it.
void add_words(const WindowMaps& maps, std::size_t ends, WordsByLength& words) {
  const auto middle = [&](const Matrix& m) {
    Functional half(maps.window, 0.0);
    half = plus(half, 0.5, row_of(m, maps.start));
    return plus(half, 0.5, row_of(m, maps.start + 1));
  };
  const Matrix one = identity(maps.window);
  const Functional here = middle(one);
  for_each_word(maps, ends, one, 0, [&](std::size_t length, const Matrix& word) {
    words[length].push_back({norm_in_differences(plus(middle(word), -1.0, here), 1), growth_of(word, 1)});
  });
}

/// The points -start, 1 - start, ... of a line, so that the piece lies between 0 and 1.
Functional ramp(const WindowMaps& maps) {
  Functional points(maps.window);
  for (std::size_t i = 0; i < maps.window; ++i) points[i] = static_cast<double>(i) - static_cast<double>(maps.start);
  return points;
}

double dot(const Functional& a, const Functional& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Whether equally spaced points of a line become points of half the distance.
bool reproduces_lines(const WindowMaps& maps) {
  constexpr double rounding = 1e-12;
  const Functional line = ramp(maps);
  const Matrix& left = maps.by_ends.front().left;
  for (std::size_t i = 0; i + 1 < maps.window; ++i) {
    if (std::abs(dot(row_of(left, i + 1), line) - dot(row_of(left, i), line) - 0.5) > rounding) return false;
  }
  return true;
}

void add_bend(const WindowMaps& maps, int levels, Reach& reach) {
  if (!reproduces_lines(maps)) return;
  const Functional line = ramp(maps);
  // A level shifts by tau of its own spacing, all together by twice that.
  const double shift = 2.0 * dot(row_of(maps.by_ends.front().left, maps.start), line);
  reach.from = std::min(0.0, shift);
  reach.to = 1.0 + std::max(0.0, shift);
  const Matrix one = identity(maps.window);
  const auto point_at = [&](const Matrix& m, double parameter) {
    const Functional point = row_of(m, maps.start);
    return plus(point, parameter, plus(row_of(m, maps.start + 1), -1.0, point));
  };
  WordsByLength words;
  for_each_word(maps, 0, one, 0, [&](std::size_t length, const Matrix& word) {
    double away = 0.0;
    for (const double end : {reach.from, reach.to}) {
      const Functional point = point_at(word, end);
      away = larger(away, norm_in_differences(plus(point, -1.0, point_at(one, dot(point, line))), 2));
    }
    words[length].push_back({away, growth_of(word, 2)});
  });
  reach.bend = table_of(words, 0.0, levels);
}

}  // namespace

Reach make_reach(const WindowMaps& maps, int levels) {
  Reach reach;
  WordsByLength words;
  add_words(maps, 0, words);
  reach.inner = table_of(words, 0.5, levels);
  for (std::size_t ends = 1; ends < maps.by_ends.size(); ++ends) add_words(maps, ends, words);
  reach.at_ends = table_of(words, 0.5, levels);
  add_bend(maps, levels, reach);
  return reach;
}

}  // namespace burin::curves::subdivision
