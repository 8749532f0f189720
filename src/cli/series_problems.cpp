#include <cstddef>
#include <map>
#include <utility>

#include <fmt/format.h>

#include <cli/draw_run.hpp>
#include <cli/file_io.hpp>
#include <cli/series_problems.hpp>

namespace burin::cli {

Result<Series> read_series(const DrawRequest& request, const PresetText& preset) {
  const Result<preset::Summary> summary = preset::summarise(preset.source, request.overrides);
  if (summary) return Series::make(request.series, preset.source, request.overrides, *summary);
  // A summary looks at little; a whole reading finds the rest of what is wrong.
  const Result<ReadyPiece> all_of_it = make_ready(preset, request.overrides, data_reader(preset.folder));
  return all_of_it ? summary.problems() : all_of_it.problems();
}

Problems grouped_problems(const std::vector<Problems>& of_result, const Series& series) {
  struct Group {
    Problem problem;
    std::size_t first = 0;
    std::size_t others = 0;
  };
  std::vector<Group> groups;
  std::map<std::string, std::size_t> group_of;
  for (std::size_t i = 0; i < of_result.size(); ++i) {
    for (const Problem& problem : of_result[i]) {
      const auto [known, is_new] = group_of.try_emplace(problem_text(problem), groups.size());
      if (is_new) {
        groups.push_back({problem, i, 0});
      } else {
        ++groups[known->second].others;
      }
    }
  }
  Problems problems;
  for (Group& group : groups) {
    if (series.count() > 1 && group.problem.trouble != Trouble::output) {
      group.problem.message += fmt::format(" [{}{}]", series.label(group.first),
                                           group.others == 0 ? "" : fmt::format(" and {} more", group.others));
    }
    problems.push_back(std::move(group.problem));
  }
  return problems;
}

std::string seed_warning(const DrawRequest& request) {
  if (request.series.seeds.empty()) return {};
  return fmt::format("warning: nothing in '{}' is random: every seed gives the same picture\n", request.preset);
}

}  // namespace burin::cli
