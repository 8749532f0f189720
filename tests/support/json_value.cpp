#include "support/json_value.hpp"

#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include <burin/expr/expression.hpp>

namespace burin::testing {

params::Value value_from_json(const nlohmann::json& json) {
  const Where where{"test", 1, 1};
  if (json.is_boolean()) return {where, json.get<bool>()};
  if (json.is_number_integer()) return {where, json.get<std::int64_t>()};
  if (json.is_number()) return {where, json.get<double>()};
  if (json.is_string()) return {where, json.get<std::string>()};
  if (json.is_array()) {
    params::Array array;
    for (const nlohmann::json& item : json) array.push_back(value_from_json(item));
    return {where, std::move(array)};
  }
  params::Table table;
  for (const auto& [key, item] : json.items()) table.entries.push_back({key, where, value_from_json(item)});
  return {where, std::move(table)};
}

ReadParams read_params(std::string_view family, std::string_view json, const ReadFile& files) {
  ReadParams read;
  params::ReadContext context{
      read.problems, [](std::string_view text, const Where& where) { return expr::evaluate_constant(text, where); },
      [](std::string_view) -> const params::Value* { return nullptr; }, files};
  const params::Value value = value_from_json(nlohmann::json::parse(json));
  read.params = curves::find_family(family)->read(*value.table(), context, {});
  return read;
}

curves::TwoPointParams two_point(std::string_view json) {
  const ReadParams read = read_params("two-point", json);
  EXPECT_TRUE(read.params.has_value()) << json << '\n' << problems_text(read.problems);
  return read.params ? std::any_cast<curves::TwoPointParams>(*read.params) : curves::TwoPointParams{};
}

const nlohmann::json& reference(const std::string& name) {
  static std::map<std::string, nlohmann::json> files;
  const auto [found, is_new] = files.try_emplace(name);
  if (is_new) {
    std::ifstream file(std::string(BURIN_SOURCE_DIR) + "/tests/reference/" + name);
    EXPECT_TRUE(file.good()) << name;
    found->second = nlohmann::json::parse(file);
  }
  return found->second;
}

}  // namespace burin::testing
