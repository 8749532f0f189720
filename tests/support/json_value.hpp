#pragma once

#include <any>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include <burin/curves/family.hpp>
#include <burin/curves/two_point/two_point.hpp>
#include <burin/params/value.hpp>

/// Parameters written as JSON, so that a test says what it draws in one line.
namespace burin::testing {

params::Value value_from_json(const nlohmann::json& json);

/// What a reader made of a value, and what it complained about.
struct ReadParams {
  std::optional<std::any> params;
  Problems problems;
};

/// Reads a family's parameters from JSON text. `files` answers for data files.
ReadParams read_params(std::string_view family, std::string_view json, const ReadFile& files = {});

/// The same for the two-point family; fails the test on problems.
curves::TwoPointParams two_point(std::string_view json);

/// A reference vector file of tests/reference, read once and kept.
const nlohmann::json& reference(const std::string& name);

}  // namespace burin::testing
