#pragma once

#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include <burin/curves/fractal_interpolation/derivatives.hpp>
#include <burin/curves/fractal_interpolation/interpolant.hpp>

/// Interpolation data for tests: from the reference's JSON, from a seed, and by hand.
namespace burin::curves::fractal_interpolation {

Scaling scaling_from(const nlohmann::json& spec);
InterpolationData data_from(const nlohmann::json& spec);

/// n intervals with the derivatives of the mean rule, alpha = beta = 3 and s = 0.
InterpolationData plain_data(std::vector<double> x, std::vector<double> values);

/// The same scaling for every interval.
InterpolationData with_scaling(InterpolationData data, const Scaling& scaling);
InterpolationData with_shape(InterpolationData data, Shape shape);

/// 2 to 6 uneven intervals, shapes from 0.1 to 8, scalings of all kinds with bounds up to `largest_scaling`.
InterpolationData random_data(std::uint64_t seed, double largest_scaling);

/// Numbers in [low, high), a new one at every call.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : seed_(seed) {}
  double operator()(double low, double high);

 private:
  std::uint64_t seed_;
  std::uint64_t count_ = 0;
};

}  // namespace burin::curves::fractal_interpolation
