#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <cli/series.hpp>

namespace burin::cli {

namespace {

constexpr std::string_view seed_name = "seed";

Problems repeated_knobs(const std::vector<Sweep>& sweeps, const preset::Overrides& overrides) {
  Problems problems;
  for (auto sweep = sweeps.begin(); sweep != sweeps.end(); ++sweep) {
    const auto same = [&](const Sweep& other) { return other.knob() == sweep->knob(); };
    const auto set = [&](const auto& knob) { return knob.first == sweep->knob(); };
    if (std::any_of(sweeps.begin(), sweep, same)) {
      problems.push_back(
          {{sweep->written()}, fmt::format("'{}' is swept twice; list all values in one --sweep", sweep->knob())});
    } else if (std::any_of(overrides.knobs.begin(), overrides.knobs.end(), set)) {
      problems.push_back({{sweep->written()}, fmt::format("'{}' is also set by -D; keep one of them", sweep->knob())});
    }
  }
  return problems;
}

/// What is wrong with the values of this sweep: each is put into its knob, and nothing else is read.
Problems wrong_values(const Sweep& sweep, const preset::Source& source, const preset::Overrides& overrides) {
  Problems all;
  for (const std::string& value : sweep.values()) {
    preset::Overrides with_value = overrides;
    with_value.knobs.emplace_back(sweep.knob(), value);
    const Result<preset::Summary> read = preset::summarise(source, with_value);
    if (read) continue;
    for (Problem problem : read.problems()) {
      problem.where = {sweep.written()};
      all.push_back(std::move(problem));
    }
  }
  return all;
}

void append(Problems& all, const Problems& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

double SeriesRequest::count() const {
  double count = 1.0;
  for (const Sweep& sweep : sweeps) count *= sweep.count();
  for (const SeedList& list : seeds) count *= list.count();
  return count;
}

Result<Series> Series::make(const SeriesRequest& request, const preset::Source& source,
                            const preset::Overrides& overrides, const preset::Summary& summary) {
  if (const double count = request.count(); count > request.max_results) {
    return Problem{{"--seed and --sweep"},
                   fmt::format("{} results are more than {}; ask for fewer or raise --max-results", count_text(count),
                               count_text(request.max_results)),
                   Trouble::limit,
                   {}};
  }
  Series series;
  series.own_seed_ = summary.seed;
  Problems problems = repeated_knobs(request.sweeps, overrides);
  for (const Sweep& sweep : request.sweeps) {
    if (const Result<Done> fits = sweep.fits(summary); !fits) {
      append(problems, fits.problems());
      continue;
    }
    append(problems, wrong_values(sweep, source, overrides));
    series.axes_.push_back({sweep.knob(), sweep.values()});
  }
  if (!problems.empty()) return problems;
  for (const SeedList& list : request.seeds) {
    Axis axis{std::string(seed_name), {}};
    for (const std::uint64_t seed : list.all()) axis.values.push_back(std::to_string(seed));
    series.axes_.push_back(std::move(axis));
  }
  return series;
}

std::size_t Series::count() const {
  std::size_t count = 1;
  for (const Axis& axis : axes_) count *= axis.values.size();
  return count;
}

std::vector<std::pair<std::string, std::string>> Series::values(std::size_t index) const {
  std::vector<std::pair<std::string, std::string>> values;
  for (auto axis = axes_.rbegin(); axis != axes_.rend(); ++axis) {
    values.emplace_back(axis->name, axis->values[index % axis->values.size()]);
    index /= axis->values.size();
  }
  std::reverse(values.begin(), values.end());
  return values;
}

std::uint64_t Series::seed(std::size_t index) const {
  std::uint64_t seed = own_seed_;
  for (const auto& [name, value] : values(index)) {
    if (name == seed_name) std::from_chars(value.data(), value.data() + value.size(), seed);
  }
  return seed;
}

preset::Overrides Series::overrides(std::size_t index, preset::Overrides common) const {
  for (auto& [name, value] : values(index)) {
    if (name == seed_name) {
      common.seed = seed(index);
    } else {
      common.knobs.emplace_back(std::move(name), std::move(value));
    }
  }
  return common;
}

std::string Series::label(std::size_t index) const {
  std::string text;
  for (const auto& [name, value] : values(index)) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
  }
  return text;
}

}  // namespace burin::cli
