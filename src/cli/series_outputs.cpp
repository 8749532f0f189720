#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include <fmt/format.h>

#include <cli/name_pattern.hpp>
#include <cli/output_target.hpp>
#include <cli/series_outputs.hpp>

namespace burin::cli {

namespace {

namespace fs = std::filesystem;

/// Names files by where they really are; folders are looked up once.
class RealNames {
 public:
  std::string of(const std::string& path) {
    const fs::path file(path);
    auto [folder, is_new] = folders_.try_emplace(file.parent_path().string());
    if (is_new) {
      std::error_code error;
      const fs::path absolute = fs::absolute(file.parent_path().empty() ? "." : file.parent_path(), error);
      const fs::path real = fs::weakly_canonical(absolute, error);
      folder->second = error ? folder->first : real.string();
    }
    return (fs::path(folder->second) / file.filename()).string();
  }

 private:
  std::map<std::string, std::string> folders_;
};

std::vector<std::string_view> known_names(const Series& series) {
  std::vector<std::string_view> names{"preset", "seed", "n"};
  for (const Axis& axis : series.axes()) {
    if (axis.name != "seed") names.emplace_back(axis.name);
  }
  return names;
}

NameValues values_of(const Series& series, std::size_t index, const PresetText& preset) {
  // Values of the series first: a knob may be called {n} or {preset}.
  NameValues values = series.values(index);
  const std::size_t width = std::to_string(series.count()).size();
  values.emplace_back("preset", preset.stem);
  values.emplace_back("seed", std::to_string(series.seed(index)));
  values.emplace_back("n", fmt::format("{:0{}}", index + 1, width));
  return values;
}

/// The pattern of one output, with what tells the results apart.
Result<NamePattern> pattern_of(const RequestedOutput& output, const Series& series, std::string& note) {
  Result<NamePattern> pattern =
      output.path.empty() ? NamePattern::of_preset(output.back_end->format) : NamePattern::read(output.path);
  if (!pattern) return pattern;
  if (const Result<Done> known = pattern->check(known_names(series)); !known) return known.problems();
  if (series.count() == 1 || pattern->has("n")) return pattern;
  bool added = false;
  for (const Axis& axis : series.axes()) {
    if (axis.values.size() == 1 || pattern->has(axis.name)) continue;
    pattern->add(axis.name);
    added = true;
  }
  if (added) note += fmt::format("note: {} results go to {}\n", series.count(), pattern->text());
  return pattern;
}

}  // namespace

Result<SeriesOutputs> name_outputs(const DrawRequest& request, const Series& series, const PresetText& preset) {
  SeriesOutputs outputs;
  outputs.of_result.resize(series.count());
  std::map<std::string, std::size_t> taken;
  RealNames real_names;
  for (const RequestedOutput& output : request.outputs) {
    if (named_descriptor(output.path)) {
      if (series.count() > 1) {
        return Problem{{request.command},
                       fmt::format("{} results cannot go into one stream; write files: -o 'out/{{preset}}-{{n}}.{}'",
                                   series.count(), output.back_end->format)};
      }
      outputs.of_result.front().push_back(output);
      continue;
    }
    Result<NamePattern> pattern = pattern_of(output, series, outputs.note);
    if (!pattern) {
      Problem problem = pattern.problems().front();
      problem.where = {request.command};
      return problem;
    }
    outputs.makes_folders = outputs.makes_folders || pattern->has_placeholders();
    for (std::size_t i = 0; i < series.count(); ++i) {
      std::string path = pattern->fill(values_of(series, i, preset));
      const auto [other, is_new] = taken.try_emplace(real_names.of(path), i);
      if (!is_new) {
        return Problem{{request.command},
                       fmt::format("two results would be written to {}: {} and {}; add {{n}} to the names, or leave "
                                   "one of them out",
                                   path, series.label(other->second), series.label(i))};
      }
      outputs.of_result[i].push_back({std::move(path), output.back_end});
    }
  }
  return outputs;
}

}  // namespace burin::cli
