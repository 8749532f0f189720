#pragma once

#include <algorithm>
#include <cstdio>
#include <vector>

#include "support/measured_run.hpp"

/// Costs of several runs. Noise only adds to a run, and it adds to both of a pair that is run in turns.
namespace burin::test {

/// Each measure for itself.
inline Cost cheapest(const Cost& a, const Cost& b) {
  return {std::min(a.cpu_s, b.cpu_s), std::min(a.wall_s, b.wall_s), std::min(a.peak_mib, b.peak_mib)};
}

inline constexpr Cost unknown{1e9, 1e9, 1e9};

// tests/bench/run.sh makes the tables of README.md of what these two print.

inline void print_row(const char* what, const Cost& cost) {
  std::printf("cost | %s | %.4f | %.4f | %.1f |\n", what, cost.cpu_s, cost.wall_s, cost.peak_mib);
}

/// How much more CPU time the second of two programs takes, pair by pair of runs.
struct Ratio {
  double least = 0.0;
  double median = 0.0;
  double most = 0.0;
};

template <class Ours, class Theirs>
Ratio times_theirs(int turns, const Ours& ours, const Theirs& theirs) {
  std::vector<double> ratios;
  for (int turn = 0; turn < turns; ++turn) {
    const double cpu_s = ours();
    ratios.push_back(theirs() / cpu_s);
  }
  std::sort(ratios.begin(), ratios.end());
  return {ratios.front(), ratios[ratios.size() / 2], ratios.back()};
}

inline void print_ratio(const char* what, const Ratio& ratio) {
  std::printf("ratio | %s | %.2f | %.2f | %.2f |\n", what, ratio.median, ratio.least, ratio.most);
}

}  // namespace burin::test
