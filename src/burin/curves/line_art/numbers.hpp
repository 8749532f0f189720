#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <burin/params/read_value.hpp>

namespace burin::curves::line_art {

/// Numbers in a list, as many as wanted.
template <std::size_t N>
struct Numbers {
  std::array<double, N> values{};
};

}  // namespace burin::curves::line_art

template <std::size_t N>
struct burin::params::ValueType<burin::curves::line_art::Numbers<N>> {
  static std::string name() { return std::to_string(N) + " numbers"; }
  static bool read(const Value& value, burin::curves::line_art::Numbers<N>& numbers, ReadContext& context) {
    const Array* array = value.array();
    if (array == nullptr) return report_kind(value, "a list of " + name(), context);
    if (array->size() != N) {
      context.report(value.where,
                     "expected a list of " + name() + ", found a list of " + std::to_string(array->size()));
      return false;
    }
    bool all = true;
    for (std::size_t i = 0; i < N; ++i) all = read_number((*array)[i], numbers.values[i], context) && all;
    return all;
  }
  static std::string text(const burin::curves::line_art::Numbers<N>&) { return {}; }
};
