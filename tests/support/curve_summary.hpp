#pragma once

#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <burin/curves/two_point/two_point.hpp>
#include <burin/path/recording.hpp>

namespace burin::testing {

/// The points of a family's curve, its paths one after another.
Recording record(std::string_view family, const std::any& params, const DrawContext& context = {});
std::vector<Vec2> draw_points(const curves::TwoPointParams& params, std::uint64_t seed = 0);
std::vector<Vec2> draw_points(std::string_view family, const nlohmann::json& params, const DrawContext& context = {});

/// Points as a base's "points".
nlohmann::json json_points(const std::vector<Vec2>& points);

/// Holds points against a list [[x, y], ...] of the reference (which may be cut short) at 1e-9 relative.
void expect_points(const std::vector<Vec2>& points, const nlohmann::json& expected);

/// Holds them against a summary {count, sum, wsum, sumsq, length, area, bbox} of the reference.
void expect_summary(const std::vector<Vec2>& points, bool closed, const nlohmann::json& expected);

}  // namespace burin::testing
