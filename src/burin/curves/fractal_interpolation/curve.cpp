#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include <burin/curves/fractal_interpolation/contour.hpp>
#include <burin/curves/fractal_interpolation/curve.hpp>
#include <burin/curves/fractal_interpolation/source_points.hpp>

namespace burin::curves::fractal_interpolation {

namespace {

/// One after the other: options, points, knots, functions. Each step reports what is wrong and then ends the work.
class Preparation {
 public:
  Preparation(const FractalInterpolationParams& params, const params::Table& table, params::ReadContext& context)
      : params_(params), table_(table), context_(context) {}

  std::optional<Curve> curve() {
    curve_.closed = params_.closed;
    curve_.planar = params_.over.value_or(params_.closed ? Over::chords : Over::x) == Over::chords;
    curve_.levels = params_.levels;
    curve_.plot = params_.plot;
    curve_.stretch = params_.stretch;
    if (!check_options() || !check_plot() || !read_points() || !place_points() || !choose_knots() || !make_functions())
      return std::nullopt;
    split_into_blocks();
    return std::move(curve_);
  }

 private:
  Where where_of(std::string_view key) const {
    const params::Value* value = table_.find(key);
    if (value == nullptr) value = table_.find("family");
    return value == nullptr ? Where{} : value->where;
  }

  bool fail(std::string_view key, std::string message) {
    context_.report(where_of(key), std::move(message));
    return false;
  }

  bool fail(const Problems& problems) {
    context_.problems.insert(context_.problems.end(), problems.begin(), problems.end());
    return false;
  }

  bool check_options() {
    if (params_.points.empty() == params_.data.empty()) {
      return fail(params_.data.empty() ? "family" : "data",
                  "a fractal interpolation needs exactly one of 'points' and 'data'");
    }
    if (!curve_.planar) {
      if (params_.closed) return fail("closed", "a function of x cannot be closed; set over = \"chords\"");
      for (const std::string_view key : {"at", "x", "y"}) {
        if (table_.find(key) != nullptr) return fail(key, fmt::format("'{}' is for over = \"chords\"", key));
      }
    }
    if (params_.fit) {
      if (!params_.intervals) return fail("fit", "'fit' needs 'intervals', fewer than there are points");
      if (params_.block) return fail("block", "'fit' and 'block' do not go together");
    }
    return true;
  }

  bool check_plot() {
    const bool compares = params_.plot == Plot::error || params_.plot == Plot::perturbation;
    if (compares && curve_.planar) return fail("plot", "errors and perturbations are drawn over x");
    if (params_.plot == Plot::error) {
      if (params_.exact.empty()) return fail("plot", "plot = \"error\" needs 'exact', an expression in x");
      constexpr std::array<std::string_view, 1> variables{"x"};
      Result<expr::Expression> compiled = expr::Expression::compile(params_.exact, variables, where_of("exact"));
      if (!compiled) return fail(compiled.problems());
      curve_.exact = *std::move(compiled);
    }
    if (params_.plot == Plot::perturbation && params_.perturbation.empty()) {
      return fail("plot", "plot = \"perturbation\" needs 'perturbation', a number for each point");
    }
    if (params_.part.empty()) return true;
    const std::vector<double>& part = params_.part;
    if (part.size() != 2 || !(0.0 <= part[0] && part[0] < part[1] && part[1] <= 1.0)) {
      return fail("part", "'part' takes [from, to] with 0 <= from < to <= 1");
    }
    curve_.part = Interval{part[0], part[1]};
    return true;
  }

  bool read_points() {
    if (params_.data.empty()) {
      source_ = {params_.points, where_of("points"), {}};
    } else {
      const Result<std::string> text = context_.read_file(params_.data);
      if (!text) {
        const Problem& problem = text.problems().front();
        return fail("data", problem.where.file.empty() ? problem.message
                                                       : fmt::format("'{}' {}", problem.where.file, problem.message));
      }
      Result<SourcePoints> points = points_of_csv(*text, params_.data);
      if (!points) return fail(points.problems());
      source_ = *std::move(points);
    }
    if (params_.lonlat) project_from_degrees(source_.points);
    if (params_.at.empty()) {
      const Repetitions repeated = drop_repeated(source_);
      if (repeated.count > 0) context_.warn(warning_of(repeated));
    }
    if (curve_.closed) close_up(source_);
    if (source_.points.size() >= 3) return true;
    return fail(
        Problems{{source_.origin, fmt::format("a fractal interpolation needs at least 3 points{}, found {}",
                                              curve_.closed ? " and the first again" : "", source_.points.size())}});
  }

  /// The parameter of every point.
  bool place_points() {
    if (!curve_.planar) {
      const Result<Done> increasing = check_increasing(source_);
      if (!increasing) return fail(increasing.problems());
      for (const Vec2 p : source_.points) t_.push_back(p.x);
      return true;
    }
    if (params_.at.empty()) {
      t_ = chord_parameters(source_.points);
      return true;
    }
    t_ = params_.at;
    if (std::adjacent_find(t_.begin(), t_.end(), std::greater_equal<>()) != t_.end()) {
      return fail("at", "the numbers of 'at' must increase");
    }
    if (t_.size() == source_.points.size()) return true;
    return fail("at", fmt::format("'at' has {} numbers for {} points{}", t_.size(), source_.points.size(),
                                  curve_.closed ? ", the first repeated at the end among them" : ""));
  }

  bool choose_knots() {
    if (!params_.intervals) {
      for (std::size_t i = 0; i < t_.size(); ++i) knots_.push_back(i);
      return true;
    }
    knots_ = spread_knots(t_, *params_.intervals);
    if (static_cast<std::size_t>(*params_.intervals) < t_.size() && knots_.size() >= 3) return true;
    return fail("intervals",
                fmt::format("{} intervals need more than {} points", *params_.intervals, source_.points.size()));
  }

  Ends ends() const { return curve_.closed ? Ends::periodic : Ends::open; }

  bool make_functions() {
    if (!curve_.planar) return make_function(&Vec2::y, nullptr);
    return make_function(&Vec2::x, &params_.x) && make_function(&Vec2::y, &params_.y);
  }

  /// One coordinate over t; `own` may override what the curve says.
  bool make_function(double Vec2::*coordinate, const Coordinate* own) {
    std::vector<double> all;
    for (const Vec2& p : source_.points) all.push_back(p.*coordinate);
    if (params_.fit) {
      functions_.push_back(fit_by(*params_.fit, {t_, all, knots_, ends()}).data);
      return true;
    }
    InterpolationData data;
    for (const std::size_t k : knots_) {
      data.x.push_back(t_[k]);
      data.values.push_back(all[k]);
    }
    const Derivatives& derivatives = own != nullptr && own->derivatives ? *own->derivatives : params_.derivatives;
    if (!set_derivatives(data, derivatives)) return false;
    const std::optional<std::vector<double>> alpha =
        spread(own != nullptr && own->alpha ? own->alpha->values : params_.alpha.values, "alpha");
    const std::optional<std::vector<double>> beta =
        spread(own != nullptr && own->beta ? own->beta->values : params_.beta.values, "beta");
    std::optional<std::vector<Scaling>> scalings =
        spread(own != nullptr && own->scaling ? own->scaling->values : params_.scaling.values, "scaling");
    if (!alpha || !beta || !scalings) return false;
    for (std::size_t i = 0; i < alpha->size(); ++i) data.shapes.push_back({(*alpha)[i], (*beta)[i]});
    data.scalings = *std::move(scalings);
    if (const DataTrouble trouble = trouble_with(data); !trouble.of.empty()) {
      return trouble.of == "points" ? fail({Problem{source_.origin, trouble.text}}) : fail(trouble.of, trouble.text);
    }
    if (params_.plot == Plot::perturbation && !perturb(data, derivatives)) return false;
    functions_.push_back(std::move(data));
    return true;
  }

  bool set_derivatives(InterpolationData& data, const Derivatives& derivatives) {
    data.derivatives = derivatives.given;
    if (derivatives.given.empty()) {
      data.derivatives = derivatives_by(derivatives.rule, data.x, data.values, ends());
    } else if (curve_.closed && derivatives.given.size() + 1 == data.x.size()) {
      data.derivatives.push_back(derivatives.given.front());
    }
    if (data.derivatives.size() == data.x.size()) return true;
    return fail("derivatives",
                fmt::format("'derivatives' has {} numbers for {} points", derivatives.given.size(), data.x.size()));
  }

  /// A value for each interval, from a list that starts over.
  template <class T>
  std::optional<std::vector<T>> spread(const std::vector<T>& list, std::string_view key) {
    const std::size_t intervals = knots_.size() - 1;
    if (intervals % list.size() != 0) {
      fail(key, fmt::format("'{}' has {} entries for {} intervals; give one, or a number of them that divides {}", key,
                            list.size(), intervals, intervals));
      return std::nullopt;
    }
    std::vector<T> each;
    for (std::size_t i = 0; i < intervals; ++i) each.push_back(list[i % list.size()]);
    return each;
  }

  /// phi is linear in its data, so that phi - phi* is the interpolant of the differences.
  bool perturb(InterpolationData& data, const Derivatives& derivatives) {
    const std::vector<double>& moved_by = params_.perturbation;
    if (moved_by.size() != data.x.size()) {
      return fail("perturbation",
                  fmt::format("'perturbation' has {} numbers for {} points", moved_by.size(), data.x.size()));
    }
    InterpolationData moved = data;
    for (std::size_t i = 0; i < moved_by.size(); ++i) moved.values[i] += moved_by[i];
    if (!set_derivatives(moved, derivatives)) return false;
    for (std::size_t i = 0; i < moved_by.size(); ++i) {
      data.values[i] = -moved_by[i];
      data.derivatives[i] -= moved.derivatives[i];
    }
    return true;
  }

  static InterpolationData slice(const InterpolationData& data, std::size_t first, std::size_t last) {
    const auto part = [&](const auto& list, std::size_t end) {
      return std::remove_cvref_t<decltype(list)>(list.begin() + static_cast<std::ptrdiff_t>(first),
                                                 list.begin() + static_cast<std::ptrdiff_t>(end));
    };
    return {part(data.x, last + 1), part(data.values, last + 1), part(data.derivatives, last + 1),
            part(data.shapes, last), part(data.scalings, last)};
  }

  void split_into_blocks() {
    const std::size_t intervals = knots_.size() - 1;
    const std::size_t wanted = params_.block ? static_cast<std::size_t>(*params_.block) : intervals;
    for (std::size_t first = 0; first < intervals;) {
      // A rest of one interval could not be refined; it joins the last block.
      const std::size_t last = intervals - first < wanted + 2 ? intervals : first + wanted;
      Block block;
      for (const InterpolationData& data : functions_) {
        block.functions.push_back(make_interpolant(slice(data, first, last)));
      }
      std::vector<Vec2> nodes;
      for (std::size_t k = first; k <= last; ++k) nodes.push_back(source_.points[knots_[k]]);
      block.chord_length = chord_length(nodes);
      curve_.blocks.push_back(std::move(block));
      first = last;
    }
  }

  const FractalInterpolationParams& params_;
  const params::Table& table_;
  params::ReadContext& context_;
  Curve curve_;
  SourcePoints source_;
  std::vector<double> t_;
  std::vector<std::size_t> knots_;
  std::vector<InterpolationData> functions_;
};

}  // namespace

std::optional<Curve> make_curve(const FractalInterpolationParams& params, const params::Table& table,
                                params::ReadContext& context) {
  return Preparation(params, table, context).curve();
}

}  // namespace burin::curves::fractal_interpolation
