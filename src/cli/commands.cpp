#include <algorithm>
#include <array>

#include <cli/command.hpp>

namespace burin::cli {

std::span<const Command> commands() {
  static const std::array table{draw_command(),       sheet_command(),   redraw_command(), watch_command(),
                                list_command(),       show_command(),    check_command(),  measure_command(),
                                new_command(),        gallery_command(), golden_command(), diff_command(),
                                primitives_command(), fit_command()};
  return table;
}

const Command* find_command(std::string_view name) {
  const std::span<const Command> all = commands();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace burin::cli
