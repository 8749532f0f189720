#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include <burin/preset/findings.hpp>

namespace burin::preset {

namespace {

/// More than anybody reads at once.
constexpr std::size_t most_shown = 500;

}  // namespace

void Findings::report_and_hush(const Where& where, std::size_t length, std::string message) {
  certain_.push_back({where, std::move(message)});
  hush(where, length);
}

void Findings::hush(const Where& where, std::size_t length) {
  int& end = hushed_[{where.file, where.line, where.column}];
  end = std::max(end, where.column + static_cast<int>(length));
}

bool Findings::is_hushed(const Where& where) const {
  if (where.line == 0) return hushed_.contains({where.file, 0, 0});
  const auto after = hushed_.upper_bound({where.file, where.line, where.column});
  if (after == hushed_.begin()) return false;
  const auto& [place, end] = *std::prev(after);
  return std::get<0>(place) == where.file && std::get<1>(place) == where.line && where.column < end;
}

Problems Findings::sorted(const std::string& file) const {
  Problems all = certain_;
  std::copy_if(problems.begin(), problems.end(), std::back_inserter(all),
               [&](const Problem& problem) { return !is_hushed(problem.where); });
  // Options keep the order in which they were read: their columns are places inside their words.
  const auto place = [&](const Problem& problem) {
    const Where& where = problem.where;
    const int rank = where.file == file ? 1 : where.line == 0 ? 0 : 2;
    return std::tuple{rank, where.line, where.line == 0 ? 0 : where.column};
  };
  std::stable_sort(all.begin(), all.end(), [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
  Problems distinct;
  for (Problem& problem : all) {
    bool repeated = false;
    for (auto said = distinct.rbegin(); said != distinct.rend() && place(*said) == place(problem); ++said) {
      repeated = repeated || (said->where.file == problem.where.file && said->message == problem.message);
    }
    if (!repeated) distinct.push_back(std::move(problem));
  }
  if (distinct.size() > most_shown) {
    const std::size_t more = distinct.size() - most_shown;
    distinct.resize(most_shown);
    distinct.push_back({{file}, fmt::format("{} more problems follow these", more)});
  }
  return distinct;
}

}  // namespace burin::preset
