#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <burin/params/read_value.hpp>

namespace burin::params {

/// So many numbers in a list.
template <std::size_t N>
struct ValueType<std::array<double, N>> {
  static std::string name() { return std::to_string(N) + " numbers"; }
  static bool read(const Value& value, std::array<double, N>& numbers, ReadContext& context) {
    const Array* array = value.array();
    if (array == nullptr) return report_kind(value, "a list of " + name(), context);
    if (array->size() != N) {
      context.report(value.where,
                     "expected a list of " + name() + ", found a list of " + std::to_string(array->size()));
      return false;
    }
    bool all = true;
    for (std::size_t i = 0; i < N; ++i) all = read_number((*array)[i], numbers[i], context) && all;
    return all;
  }
  static std::string text(const std::array<double, N>& numbers) {
    std::string all;
    for (const double number : numbers) all += (all.empty() ? "" : ", ") + ValueType<double>::text(number);
    return '[' + all + ']';
  }
};

}  // namespace burin::params
