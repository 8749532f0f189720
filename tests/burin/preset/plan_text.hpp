#pragma once

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/plan.hpp>

/// Plans of presets as short texts, and what they draw.
namespace burin::preset {

inline Result<Plan> try_plan_text(const std::string& text, const ReadFile& read_file = {}) {
  Result<Piece> piece = load({"p.toml", text}, {}, read_file);
  if (!piece) return piece.problems();
  return Plan::make(*std::move(piece));
}

/// The plan of a preset that must be right.
inline Plan plan_text(const std::string& text, const ReadFile& read_file = {}) {
  Result<Plan> plan = try_plan_text(text, read_file);
  if (!plan) throw std::runtime_error(problems_text(plan.problems()));
  return *std::move(plan);
}

/// What is wrong first, without the source line; empty when nothing is.
inline std::string first_complaint(const std::string& text, const ReadFile& read_file = {}) {
  const Result<Plan> plan = try_plan_text(text, read_file);
  if (plan) return {};
  Problem problem = plan.problems().front();
  problem.source_line.clear();
  return problem_text(problem);
}

inline Recording drawn(const Plan& plan, const RunOptions& options = {}) {
  Recorder recorder;
  Checked checked(recorder);
  EXPECT_EQ(plan.run(checked, options), Flow::go);
  return recorder.take();
}

}  // namespace burin::preset
