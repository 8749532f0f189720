#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include <cli/single_request.hpp>

namespace burin::cli {

namespace {

constexpr std::array<std::string_view, 3> of_several{"sweep", "max-results", "threads"};

/// What means less where there is one result.
constexpr std::array plainer_rows{
    OptionRow{"output", 'o', "FILE", "write here, in the format of the suffix; - is stdout", true},
    OptionRow{"seed", 0, "SEED", "seed of everything random: a whole number, or random"},
};

}  // namespace

std::vector<OptionRow> single_options(std::span<const OptionRow> own) {
  std::vector<OptionRow> rows;
  for (const OptionRow& row : draw_options()) {
    if (std::find(of_several.begin(), of_several.end(), row.name) != of_several.end()) continue;
    const auto plainer =
        std::find_if(plainer_rows.begin(), plainer_rows.end(), [&](const OptionRow& r) { return r.name == row.name; });
    rows.push_back(plainer == plainer_rows.end() ? row : *plainer);
  }
  rows.insert(rows.end(), own.begin(), own.end());
  return rows;
}

Result<DrawRequest> read_single_request(const Arguments& arguments, const std::string& command,
                                        const PreferredBackEnd& preferred) {
  Result<DrawRequest> request = read_draw_request(arguments, command, preferred);
  if (request && !request->series.seeds.empty()) {
    return Problem{{command},
                   fmt::format("one seed at a time, not '{}'; 'burin draw' draws many", *arguments.value("seed"))};
  }
  return request;
}

}  // namespace burin::cli
