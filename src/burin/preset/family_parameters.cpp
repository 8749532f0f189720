#include <optional>
#include <string_view>

#include <fmt/format.h>

#include <burin/expr/expression.hpp>
#include <burin/preset/family_parameters.hpp>
#include <burin/preset/findings.hpp>
#include <burin/preset/toml.hpp>

namespace burin::preset {

Result<std::any> family_parameters(const curves::Family& family,
                                   const std::vector<std::pair<std::string, std::string>>& values,
                                   const ReadFile& read_file) {
  Findings findings;
  params::Table table;
  for (const auto& [name, text] : values) {
    const Where where{fmt::format("-D {}={}", name, text)};
    std::optional<params::Value> value = parse_toml_value(text, where, findings);
    table.set(name, value ? *std::move(value) : params::Value{where, text});
  }
  params::ReadContext context{
      .problems = findings.problems,
      .evaluate = [](std::string_view text, const Where& where) { return expr::evaluate_constant(text, where); },
      .defined = [](std::string_view) -> const params::Value* { return nullptr; },
      .read_file = read_file};
  std::optional<std::any> parameters = family.read(table, context, {});
  if (!findings.empty()) return findings.sorted({});
  return *std::move(parameters);
}

}  // namespace burin::preset
