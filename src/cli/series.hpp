#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <burin/preset/load.hpp>
#include <cli/seed_list.hpp>
#include <cli/sweep.hpp>

namespace burin::cli {

/// What differs between the results of one command, as asked for.
struct SeriesRequest {
  std::vector<Sweep> sweeps;
  std::vector<SeedList> seeds;  ///< none or one
  double max_results = 10000.0;

  double count() const;
};

/// A knob, or "seed", and the values it goes through.
struct Axis {
  std::string name;
  std::vector<std::string> values;
};

/// Results of one command, one for each combination of the axes' values; the last axis goes fastest. Without axes:
/// one result.
class Series {
 public:
  /// Sweeps in the order of the command line, then the seeds, held against the preset's `summary`. Problems: too many
  /// results (Trouble::limit), a knob that is not there, given twice or also set by -D, a value that the knob does not
  /// take.
  static Result<Series> make(const SeriesRequest& request, const preset::Source& source,
                             const preset::Overrides& overrides, const preset::Summary& summary);

  std::size_t count() const;
  const std::vector<Axis>& axes() const { return axes_; }
  /// Names and values of one result, in the order of the axes. Pre: index < count().
  std::vector<std::pair<std::string, std::string>> values(std::size_t index) const;
  /// Pre: index < count().
  std::uint64_t seed(std::size_t index) const;
  /// The overrides of one result.
  preset::Overrides overrides(std::size_t index, preset::Overrides common) const;
  /// "levels=3 seed=7"; empty without axes.
  std::string label(std::size_t index) const;

 private:
  std::vector<Axis> axes_;
  std::uint64_t own_seed_ = 1;  ///< of results for which no axis has one
};

}  // namespace burin::cli
