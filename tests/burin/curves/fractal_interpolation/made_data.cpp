#include "made_data.hpp"

#include <burin/base/random.hpp>

namespace burin::curves::fractal_interpolation {

Scaling scaling_from(const nlohmann::json& spec) {
  if (!spec.is_object()) return {Scaling::Kind::chebyshev, spec.get<std::vector<double>>()};
  const std::string kind = spec["kind"];
  return {kind == "cheb"  ? Scaling::Kind::chebyshev
          : kind == "sin" ? Scaling::Kind::sine
                          : Scaling::Kind::exponential,
          spec["c"].get<std::vector<double>>()};
}

InterpolationData data_from(const nlohmann::json& spec) {
  InterpolationData data{spec["x"], spec["f"], spec["d"], {}, {}};
  for (std::size_t i = 0; i < spec["alpha"].size(); ++i) {
    data.shapes.push_back({spec["alpha"][i], spec["beta"][i]});
    data.scalings.push_back(scaling_from(spec["s"][i]));
  }
  return data;
}

InterpolationData plain_data(std::vector<double> x, std::vector<double> values) {
  const std::size_t n = x.size() - 1;
  std::vector<double> derivatives = mean_derivatives(x, values, Ends::open);
  return {std::move(x), std::move(values), std::move(derivatives), std::vector<Shape>(n), std::vector<Scaling>(n)};
}

InterpolationData with_scaling(InterpolationData data, const Scaling& scaling) {
  for (Scaling& each : data.scalings) each = scaling;
  return data;
}

InterpolationData with_shape(InterpolationData data, Shape shape) {
  for (Shape& each : data.shapes) each = shape;
  return data;
}

InterpolationData random_data(std::uint64_t seed, double largest_scaling) {
  Draws draw(seed);
  const auto n = static_cast<std::size_t>(draw(2.0, 7.0));
  InterpolationData data;
  double x = draw(-5.0, 5.0);
  for (std::size_t i = 0; i <= n; ++i) {
    data.x.push_back(x);
    data.values.push_back(draw(-2.0, 2.0));
    data.derivatives.push_back(draw(-3.0, 3.0));
    x += draw(0.1, 1.0);
  }
  for (std::size_t i = 0; i < n; ++i) {
    data.shapes.push_back({draw(0.1, 8.0), draw(0.1, 8.0)});
    const double s = largest_scaling;
    switch (static_cast<int>(draw(0.0, 4.0))) {
      case 0:
        data.scalings.push_back(constant_scaling(draw(-s, s)));
        break;
      case 1:
        data.scalings.push_back({Scaling::Kind::chebyshev, {draw(-s, s) / 3.0, draw(-s, s) / 3.0, draw(-s, s) / 3.0}});
        break;
      case 2:
        data.scalings.push_back({Scaling::Kind::sine, {draw(-s, s) / 2.0, draw(-s, s) / 2.0, draw(1.0, 9.0), 0.4}});
        break;
      default:
        data.scalings.push_back({Scaling::Kind::exponential, {draw(-s, s), draw(-2.0, 0.0)}});
    }
  }
  return data;
}

double Draws::operator()(double low, double high) {
  return low + (high - low) * uniform(seed_, count_++);
}

}  // namespace burin::curves::fractal_interpolation
