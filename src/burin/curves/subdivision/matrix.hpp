#pragma once

#include <cstddef>
#include <vector>

namespace burin::curves::subdivision {

/// A small square matrix, row by row.
struct Matrix {
  std::size_t size = 0;
  std::vector<double> entries;

  explicit Matrix(std::size_t n) : size(n), entries(n * n) {}
  double& at(std::size_t row, std::size_t column) { return entries[row * size + column]; }
  double at(std::size_t row, std::size_t column) const { return entries[row * size + column]; }
};

/// Pre: a and b have the same size.
inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result(a.size);
  for (std::size_t row = 0; row < a.size; ++row) {
    for (std::size_t k = 0; k < a.size; ++k) {
      for (std::size_t column = 0; column < a.size; ++column) {
        result.at(row, column) += a.at(row, k) * b.at(k, column);
      }
    }
  }
  return result;
}

}  // namespace burin::curves::subdivision
