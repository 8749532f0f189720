#include <iostream>

#include <burin/burin.hpp>

int main() {
  const burin::preset::Source snowflake{"snowflake.toml", R"(burin = 1
[knobs]
levels = { default = 4, min = 0, max = 9, doc = "refinement levels" }
[[layer]]
curve = { family = "two-point", motif = "koch", base = "triangle", levels = "$levels" }
)"};
  burin::preset::Overrides changes;
  changes.knobs = {{"levels", "2"}};
  const auto plan = burin::load(snowflake, changes);
  const auto svg = plan ? burin::to_svg(*plan) : burin::Result<std::string>(plan.problems());
  if (!svg) std::cerr << burin::problems_text(svg.problems());
  if (svg) std::cout << *svg;
  return svg ? 0 : 1;
}
