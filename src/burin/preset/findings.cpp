#include <algorithm>
#include <burin/preset/findings.hpp>
#include <tuple>

namespace burin::preset {

void Findings::report_and_hush(const Where& where, std::size_t length, std::string message) {
  certain_.push_back({where, std::move(message)});
  hush(where, length);
}

void Findings::hush(const Where& where, std::size_t length) {
  hushed_.push_back({where, where.column + static_cast<int>(length)});
}

bool Findings::is_hushed(const Where& where) const {
  return std::any_of(hushed_.begin(), hushed_.end(), [&](const Hushed& span) {
    if (span.where.file != where.file || span.where.line != where.line) return false;
    return where.line == 0 || (span.where.column <= where.column && where.column < span.end_column);
  });
}

Problems Findings::sorted(const std::string& file) const {
  Problems all = certain_;
  std::copy_if(problems.begin(), problems.end(), std::back_inserter(all),
               [&](const Problem& problem) { return !is_hushed(problem.where); });
  const auto rank = [&](const Where& where) {
    if (where.file == file) return 1;
    return where.line == 0 ? 0 : 2;
  };
  const auto place = [&](const Problem& problem) {
    const Where& where = problem.where;
    // The options keep the order in which they were given; their columns are places inside their words.
    return std::tuple{rank(where.file == file || where.line > 0 ? where : Where{where.file}), where.line,
                      where.line == 0 ? 0 : where.column};
  };
  std::stable_sort(all.begin(), all.end(), [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
  Problems distinct;
  for (Problem& problem : all) {
    const bool repeated = std::any_of(distinct.begin(), distinct.end(), [&](const Problem& said) {
      return place(said) == place(problem) && said.where.file == problem.where.file && said.message == problem.message;
    });
    if (!repeated) distinct.push_back(std::move(problem));
  }
  return distinct;
}

}  // namespace burin::preset
