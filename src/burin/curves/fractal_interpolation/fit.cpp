#include <functional>
#include <utility>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/curves/fractal_interpolation/contour.hpp>
#include <burin/curves/fractal_interpolation/fit.hpp>
#include <burin/curves/fractal_interpolation/least_squares.hpp>
#include <burin/geom/box2.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

/// g at x by linear interpolation.
double between_places(const DenseData& dense, double x) {
  const auto above = std::upper_bound(dense.t.begin(), dense.t.end(), x);
  const auto right =
      std::clamp<std::ptrdiff_t>(above - dense.t.begin(), 1, static_cast<std::ptrdiff_t>(dense.t.size()) - 1);
  const auto k = static_cast<std::size_t>(right);
  const double u = std::clamp((x - dense.t[k - 1]) / (dense.t[k] - dense.t[k - 1]), 0.0, 1.0);
  return dense.g[k - 1] + u * (dense.g[k] - dense.g[k - 1]);
}

/// The places inside one interval, or every so-manieth of them, and what the collage needs of them.
class IntervalCollage {
 public:
  IntervalCollage(const DenseData& dense, const Interpolant& f, std::size_t interval, std::size_t coefficients,
                  std::size_t most_places)
      : own_(f.pieces[interval].ends), whole_(f.whole), coefficients_(coefficients) {
    const std::size_t first = dense.knots[interval];
    const std::size_t last = dense.knots[interval + 1];
    const std::size_t step = (last - first - 1) / most_places + 1;
    for (std::size_t j = first + 1; j < last; j += step) {
      const double theta = (dense.t[j] - dense.t[first]) / (dense.t[last] - dense.t[first]);
      places_.push_back({theta, dense.g[j], between_places(dense, f.begin + theta * f.length)});
    }
    residual_.resize(places_.size());
    columns_.resize(places_.size() * coefficients_);
  }

  bool empty() const { return places_.empty(); }
  /// The coefficients of the last `error`.
  const std::vector<double>& scaling() const { return scaling_; }

  /// The squared collage error of these shape parameters with the best scaling.
  double error(Shape shape) {
    const std::size_t k = coefficients_;
    gram_.assign(k * k, 0.0);
    moment_.assign(k, 0.0);
    for (std::size_t j = 0; j < places_.size(); ++j) {
      const Place& place = places_[j];
      const Weights w = weights_at(place.theta, shape);
      residual_[j] = place.value - combine(w, own_);
      if (k == 0) continue;
      double* const row = columns_.data() + j * k;
      fill_row(row, place.theta, place.source - combine(w, whole_));
      for (std::size_t a = 0; a < k; ++a) {
        moment_[a] += row[a] * residual_[j];
        for (std::size_t b = 0; b < k; ++b) gram_[a * k + b] += row[a] * row[b];
      }
    }
    scaling_ = k == 0 ? std::vector<double>{0.0} : least_squares_within(gram_, moment_, largest_fitted_scaling);
    double sum = 0.0;
    for (std::size_t j = 0; j < places_.size(); ++j) {
      double left = residual_[j];
      for (std::size_t a = 0; a < k; ++a) left -= columns_[j * k + a] * scaling_[a];
      sum += left * left;
    }
    return sum;
  }

 private:
  struct Place {
    double theta;
    double value;   ///< g here
    double source;  ///< g at the place of the whole that maps here
  };

  /// distance T_0, distance T_1, ...
  void fill_row(double* row, double theta, double distance) const {
    const double u = 2.0 * theta - 1.0;
    row[0] = distance;
    if (coefficients_ > 1) row[1] = u * distance;
    for (std::size_t a = 2; a < coefficients_; ++a) row[a] = 2.0 * u * row[a - 1] - row[a - 2];
  }

  EndData own_;
  EndData whole_;
  std::size_t coefficients_;
  std::vector<Place> places_;
  std::vector<double> residual_;
  std::vector<double> columns_;
  std::vector<double> gram_;
  std::vector<double> moment_;
  std::vector<double> scaling_{0.0};
};

/// Two shape parameters need no more places than this; the coefficients, which cost little, take all.
constexpr std::size_t most_places_searched = 400;

/// log alpha, log beta.
struct LogShape {
  double alpha;
  double beta;
  Shape shape() const { return {math::exp(alpha), math::exp(beta)}; }
};

/// The best shape parameters: 25 starts and (3, 3), then a pattern search with steps from 1 down to the finest. A
/// smooth curve has long narrow valleys, where the steps of 0.02 that the reference ends with stop at twice the error.
Shape search_shape(IntervalCollage& collage) {
  const double limit = math::log(1e3);
  Shape best{};
  LogShape at{math::log(best.alpha), math::log(best.beta)};
  double least = collage.error(best);
  for (double alpha = -4.0; alpha <= 4.0; alpha += 2.0) {
    for (double beta = -4.0; beta <= 4.0; beta += 2.0) {
      const LogShape start{alpha, beta};
      if (const double error = collage.error(start.shape()); error < least) {
        least = error;
        at = start;
        best = start.shape();
      }
    }
  }
  constexpr std::array<std::pair<double, double>, 8> directions{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
  constexpr double finest_step = 2e-4;
  for (double step = 1.0; step > finest_step;) {
    const bool moved = std::any_of(directions.begin(), directions.end(), [&](const auto& direction) {
      const LogShape next{std::clamp(at.alpha + step * direction.first, -limit, limit),
                          std::clamp(at.beta + step * direction.second, -limit, limit)};
      const double error = collage.error(next.shape());
      if (!(error < least * (1.0 - 1e-9))) return false;
      least = error;
      at = next;
      best = next.shape();
      return true;
    });
    if (!moved) step *= 0.5;
  }
  return best;
}

/// A fit to more places than both of these comes no nearer.
constexpr std::size_t enough_places = 200'000;
constexpr std::size_t enough_in_interval = 200;

/// Every `step`-th index from each knot to the next, and the last knot.
std::vector<std::size_t> sampled(std::span<const std::size_t> knots, std::size_t step) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    for (std::size_t k = knots[i]; k < knots[i + 1]; k += step) places.push_back(k);
  }
  places.push_back(knots.back());
  return places;
}

template <class ValueAt>
std::vector<double> taken(std::span<const std::size_t> places, const ValueAt& value_at_place) {
  std::vector<double> values;
  values.reserve(places.size());
  for (const std::size_t k : places) values.push_back(value_at_place(k));
  return values;
}

InterpolationData knot_data(const DenseData& dense) {
  BURIN_EXPECT(dense.t.size() == dense.g.size() && dense.knots.size() >= 2 && dense.knots.front() == 0 &&
               dense.knots.back() + 1 == dense.t.size());
  InterpolationData data;
  for (const std::size_t k : dense.knots) {
    data.x.push_back(dense.t[k]);
    data.values.push_back(dense.g[k]);
  }
  data.shapes.resize(dense.knots.size() - 1);
  data.scalings.resize(dense.knots.size() - 1);
  return data;
}

double mean_square_of(const InterpolationData& data, const DenseData& dense) {
  const Interpolant f = make_interpolant(data);
  double sum = 0.0;
  for (std::size_t j = 0; j < dense.t.size(); ++j) {
    const double miss = value_at(f, dense.t[j], 1e-9 * (std::abs(f.whole.left) + f.gap)) - dense.g[j];
    sum += miss * miss;
  }
  return sum / static_cast<double>(dense.t.size());
}

/// Each interval's scaling, and shape if it is searched for; then the error of all.
void fit_intervals(const DenseData& dense, CoordinateFit& fit, std::size_t coefficients, bool search_shapes) {
  const Interpolant f = make_interpolant(fit.data);
  for (std::size_t i = 0; i < f.pieces.size() && (coefficients > 0 || search_shapes); ++i) {
    if (search_shapes) {
      IntervalCollage sample(dense, f, i, coefficients, most_places_searched);
      if (!sample.empty()) fit.data.shapes[i] = search_shape(sample);
    }
    IntervalCollage collage(dense, f, i, coefficients, dense.t.size());
    if (collage.empty()) continue;
    collage.error(fit.data.shapes[i]);
    fit.data.scalings[i] = {Scaling::Kind::chebyshev, collage.scaling()};
  }
  fit.mean_square = mean_square_of(fit.data, dense);
}

}  // namespace

std::vector<double> derivatives_by(DerivativeRule rule, std::span<const double> x, std::span<const double> values,
                                   Ends ends) {
  return rule == DerivativeRule::mean ? mean_derivatives(x, values, ends) : spline_derivatives(x, values, ends);
}

CoordinateFit collage_fit(const DenseData& dense, DerivativeRule rule, std::size_t coefficients, bool shapes) {
  CoordinateFit fit{rule, knot_data(dense), 0.0};
  fit.data.derivatives = derivatives_by(rule, fit.data.x, fit.data.values, dense.ends);
  fit_intervals(dense, fit, coefficients, shapes);
  return fit;
}

CoordinateFit collage_fit(const DenseData& dense, std::vector<double> derivatives, std::vector<Shape> shapes,
                          std::size_t coefficients) {
  CoordinateFit fit{DerivativeRule::mean, knot_data(dense), 0.0};
  fit.data.derivatives = std::move(derivatives);
  fit.data.shapes = std::move(shapes);
  fit_intervals(dense, fit, coefficients, false);
  return fit;
}

std::vector<CoordinateFit> fits_up_to(Method last, const DenseData& dense) {
  const auto better = [](const CoordinateFit& a, const CoordinateFit& b) {
    return b.mean_square < a.mean_square ? b : a;
  };
  const auto by_both_rules = [&](std::size_t coefficients, bool shapes) {
    return better(collage_fit(dense, DerivativeRule::mean, coefficients, shapes),
                  collage_fit(dense, DerivativeRule::spline, coefficients, shapes));
  };
  std::vector<CoordinateFit> fits{collage_fit(dense, DerivativeRule::spline, 0, false)};
  if (last == Method::cubic_spline) return fits;
  const CoordinateFit constant = better(fits[0], by_both_rules(1, false));
  fits.push_back(better(constant, by_both_rules(2, false)));
  if (last == Method::polynomial_function) return fits;
  fits.push_back(better(constant, by_both_rules(1, true)));
  if (last == Method::rational_constant) return fits;
  fits.push_back(better(better(fits[1], fits[2]), by_both_rules(2, true)));
  return fits;
}

CoordinateFit fit_by(Method method, const DenseData& dense) {
  return std::move(fits_up_to(method, dense).back());
}

Comparison compare_methods(std::span<const Vec2> points, int intervals, Ends ends) {
  Box2 box;
  for (const Vec2 p : points) box.add(p);
  const double scale = 1.0 / std::max(box.width(), box.height());
  std::vector<Vec2> unit;
  for (const Vec2 p : points) unit.push_back(scale * (p - box.low));
  Comparison comparison;
  comparison.t = chord_parameters(unit);
  comparison.knots = spread_knots(comparison.t, intervals);
  comparison.step = points.size() / std::max(enough_places, enough_in_interval * comparison.knots.size()) + 1;
  const std::vector<std::size_t> places = sampled(comparison.knots, comparison.step);
  const std::vector<double> t = taken(places, [&](std::size_t k) { return comparison.t[k]; });
  std::vector<std::size_t> knots;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (places[k] == comparison.knots[knots.size()]) knots.push_back(k);
  }
  const auto fitted = [&](double Vec2::*coordinate) {
    const std::vector<double> g = taken(places, [&](std::size_t k) { return unit[k].*coordinate; });
    return fits_up_to(Method::rational_function, {t, g, knots, ends});
  };
  const std::vector<CoordinateFit> x = fitted(&Vec2::x);
  const std::vector<CoordinateFit> y = fitted(&Vec2::y);
  for (std::size_t k = 0; k < method_count; ++k) {
    comparison.fits[k] = {{x[k], y[k]}, std::sqrt(x[k].mean_square + y[k].mean_square)};
  }
  return comparison;
}

std::size_t stored_numbers(Method method, std::size_t intervals) {
  constexpr std::array<std::size_t, method_count> fitted_per_interval{0, 4, 6, 8};
  return 3 * (intervals + 1) + fitted_per_interval[static_cast<std::size_t>(method)] * intervals;
}

}  // namespace burin::curves::fractal_interpolation
