#pragma once

#include <algorithm>
#include <cstdio>

#include "support/measured_run.hpp"

/// Costs of repeated runs.
namespace burin::test {

/// The cheapest of several runs, each measure for itself: noise only adds.
inline Cost cheapest(const Cost& a, const Cost& b) {
  return {std::min(a.cpu_s, b.cpu_s), std::min(a.wall_s, b.wall_s), std::min(a.peak_mib, b.peak_mib)};
}

inline constexpr Cost unknown{1e9, 1e9, 1e9};

inline void print_row(const char* what, const Cost& cost) {
  std::printf("%-28s cpu %7.4f s  wall %7.4f s  peak %6.1f MiB\n", what, cost.cpu_s, cost.wall_s, cost.peak_mib);
}

}  // namespace burin::test
