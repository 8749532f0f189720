#include <cmath>
#include <utility>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/curves/fractal_interpolation/least_squares.hpp>
#include <burin/curves/fractal_interpolation/refine.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

constexpr double negligible = 1e-10;
constexpr int deepest = 60;
const double most_log_shape = math::log(1e3);

/// phi(x) and its derivatives by everything that may move: for interval i first its coefficients, then log alpha and
/// log beta. The addresses of the places do not depend on these.
class Model {
 public:
  Model(const DenseData& dense, std::size_t coefficients, Freedom freedom)
      : dense_(dense), coefficients_(coefficients), freedom_(freedom) {}

  std::size_t per_interval() const { return coefficients_ + 2; }

  /// The sum of squared errors; with `gram` and `moment` also J'J and J'r.
  double evaluate(const Interpolant& f, std::vector<double>* gram, std::vector<double>* moment) {
    const std::size_t unknowns = f.pieces.size() * per_interval();
    if (gram != nullptr) {
      gram->assign(unknowns * unknowns, 0.0);
      moment->assign(unknowns, 0.0);
    }
    double sum = 0.0;
    for (std::size_t j = 0; j < dense_.t.size(); ++j) {
      walk(f, dense_.t[j]);
      const double residual = values_.front() - dense_.g[j];
      sum += residual * residual;
      if (gram == nullptr) continue;
      differentiate(f);
      for (const auto& [a, slope] : row_) {
        (*moment)[a] += slope * residual;
        for (const auto& [b, other] : row_) (*gram)[a * unknowns + b] += slope * other;
      }
    }
    return sum;
  }

 private:
  struct Step {
    std::size_t piece;
    double theta;
    double scaling;
    double own;
    double whole;
  };

  /// The address of x until what is left does not matter, and phi at each of its places.
  void walk(const Interpolant& f, double x) {
    steps_.clear();
    double theta = std::clamp((x - f.begin) / f.length, 0.0, 1.0);
    double factor = 1.0;
    for (int k = 0; k < deepest && (k < 2 || std::abs(factor) > negligible); ++k) {
      const std::size_t i = piece_at(f, theta);
      const Piece& piece = f.pieces[i];
      theta = std::clamp((theta - piece.start) / piece.width, 0.0, 1.0);
      const Weights w = weights_at(theta, piece.shape);
      steps_.push_back({i, theta, scaling_at(piece.scaling, theta), combine(w, piece.ends), combine(w, f.whole)});
      factor *= steps_.back().scaling;
    }
    values_.resize(steps_.size());
    values_.back() = steps_.back().own;
    for (std::size_t k = steps_.size() - 1; k-- > 0;) {
      values_[k] = steps_[k].own + steps_[k].scaling * (values_[k + 1] - steps_[k].whole);
    }
  }

  void add(std::size_t unknown, double slope) {
    for (auto& [known, sum] : row_) {
      if (known == unknown) {
        sum += slope;
        return;
      }
    }
    row_.emplace_back(unknown, slope);
  }

  void differentiate(const Interpolant& f) {
    row_.clear();
    double factor = 1.0;
    for (std::size_t k = 0; k + 1 < steps_.size(); ++k) {
      const Step& step = steps_[k];
      const Piece& piece = f.pieces[step.piece];
      const std::size_t first = step.piece * per_interval();
      if (freedom_.scalings) {
        const double u = 2.0 * step.theta - 1.0;
        const double distance = values_[k + 1] - step.whole;
        double before = 0.0;
        double chebyshev = 1.0;
        for (std::size_t l = 0; l < coefficients_; ++l) {
          add(first + l, factor * chebyshev * distance);
          before = std::exchange(chebyshev, l == 0 ? u : 2.0 * u * chebyshev - before);
        }
      }
      if (freedom_.shapes) {
        const Weights w = weights_at(step.theta, piece.shape);
        const auto shape_slope = [&](double weight, double own_end, double whole_end) {
          return factor * weight * ((own_end - step.own) - step.scaling * (whole_end - step.whole));
        };
        add(first + coefficients_, piece.shape.alpha * shape_slope(w.left_slope, piece.ends.left, f.whole.left));
        add(first + coefficients_ + 1, piece.shape.beta * shape_slope(-w.right_slope, piece.ends.right, f.whole.right));
      }
      factor *= step.scaling;
    }
  }

  const DenseData& dense_;
  std::size_t coefficients_;
  Freedom freedom_;
  std::vector<Step> steps_;
  std::vector<double> values_;
  std::vector<std::pair<std::size_t, double>> row_;
};

/// The parameters after a step, kept to where they are allowed.
InterpolationData moved(const InterpolationData& data, const std::vector<double>& step, std::size_t coefficients,
                        Freedom freedom) {
  InterpolationData next = data;
  for (std::size_t i = 0; i < data.shapes.size(); ++i) {
    const double* own = step.data() + i * (coefficients + 2);
    if (freedom.scalings) {
      for (std::size_t l = 0; l < coefficients; ++l) next.scalings[i].c[l] += own[l];
      next.scalings[i].c = project_on_l1_ball(std::move(next.scalings[i].c), largest_fitted_scaling);
    }
    if (freedom.shapes) {
      const auto shifted = [](double value, double by) {
        return math::exp(std::clamp(math::log(value) + std::clamp(by, -2.0, 2.0), -most_log_shape, most_log_shape));
      };
      next.shapes[i] = {shifted(data.shapes[i].alpha, own[coefficients]),
                        shifted(data.shapes[i].beta, own[coefficients + 1])};
    }
  }
  return next;
}

/// The step of the damped normal equations.
std::vector<double> damped_step(std::vector<double> gram, std::vector<double> moment, double damping) {
  const std::size_t n = moment.size();
  double largest = 1e-300;
  for (std::size_t a = 0; a < n; ++a) largest = std::max(largest, gram[a * n + a]);
  for (std::size_t a = 0; a < n; ++a) {
    gram[a * n + a] += damping * gram[a * n + a] + 1e-9 * largest * std::max(damping, 1e-3);
    moment[a] = -moment[a];
  }
  return least_squares(gram, moment);
}

}  // namespace

CoordinateFit refined(const DenseData& dense, CoordinateFit start, Freedom freedom, int rounds) {
  std::size_t coefficients = 1;
  for (const Scaling& scaling : start.data.scalings) {
    BURIN_EXPECT(scaling.kind == Scaling::Kind::chebyshev);
    coefficients = std::max(coefficients, scaling.c.size());
  }
  for (Scaling& scaling : start.data.scalings) scaling.c.resize(coefficients, 0.0);
  Model model(dense, coefficients, freedom);
  std::vector<double> gram;
  std::vector<double> moment;
  double sum = model.evaluate(make_interpolant(start.data), &gram, &moment);
  double damping = 1e-3;
  for (int round = 0; round < rounds; ++round) {
    double next_sum = sum;
    for (int attempt = 0; attempt < 8; ++attempt) {
      InterpolationData next = moved(start.data, damped_step(gram, moment, damping), coefficients, freedom);
      next_sum = model.evaluate(make_interpolant(next), nullptr, nullptr);
      if (next_sum < sum) {
        start.data = std::move(next);
        break;
      }
      damping *= 5.0;
    }
    if (!(next_sum < sum * (1.0 - 1e-5))) break;
    damping = std::max(damping / 5.0, 1e-9);
    sum = model.evaluate(make_interpolant(start.data), &gram, &moment);
  }
  start.mean_square = std::min(sum, model.evaluate(make_interpolant(start.data), nullptr, nullptr)) /
                      static_cast<double>(dense.t.size());
  return start;
}

}  // namespace burin::curves::fractal_interpolation
