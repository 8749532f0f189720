#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <burin/base/executor.hpp>
#include <burin/base/result.hpp>
#include <burin/geom/vec2.hpp>
#include <burin/path/back_end.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/preset/enlargement.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// A part of the page that is blown up to fill it, with the page's own proportions. Pens keep their widths.
struct PageWindow {
  Vec2 center_mm;         ///< on the page, y down
  double width_mm = 0.0;  ///< above 0
};

/// How a plan is run, once for each output.
struct RunOptions {
  Space space = Space::page;
  double tolerance_mm = 0.0;                        ///< what the output can show; 0: every point
  Box2 part_mm = Box2::everything();                ///< of the page; what does not come near it may be left out
  std::function<bool(const SheetLayer&)> wanted{};  ///< null: every layer
  std::stop_token stop{};
  const Executor* executor = nullptr;
  std::optional<PageWindow> window{};  ///< of the page space; nothing: the page as it is
};

struct PlanStep;

/// A piece fitted to its page and ready to be drawn, as often as one likes: each run replays the generators into a
/// sink. Const and free of state; runs may go on at the same time.
class Plan {
 public:
  /// Fits every slot. A problem: a slot without ink to fit, a curve that leaves the range of numbers.
  static Result<Plan> make(Piece piece);

  const Sheet& sheet() const { return *sheet_; }
  /// For Origin: filled in by whoever knows what was asked for.
  void set_origin(Origin origin);

  /// What a run would emit, counted up to `enough` points.
  Forecast forecast(const RunOptions& options, double enough) const;
  /// An error that names the costliest layer and what to lower, when a run would emit more than `max_points`.
  Result<Forecast> check_size(const RunOptions& options, double max_points) const;

  /// Draws every wanted layer into the sink. Flow::stop: the sink or the stop token ended it early.
  Flow run(PathSink& sink, const RunOptions& options) const;

  /// Whether another seed gives another picture.
  bool uses_seed() const;

 private:
  /// The options for the planned page, whose drawing an enlargement makes coarser.
  RunOptions before_enlarging(RunOptions options) const;
  Flow run_steps(PathSink& sink, const RunOptions& options) const;

  std::shared_ptr<Sheet> sheet_;
  Page page_;  ///< as planned
  std::optional<Enlargement> enlargement_;
  std::shared_ptr<const std::vector<PlanStep>> steps_;
  std::shared_ptr<const std::vector<PlanStep>> hiding_;  ///< the layers that hide others, each whole
  bool seed_in_values_ = false;
};

/// Calls `run`, which draws into the back end's sink, as often as the sink wants, each time for the part that it wants.
Flow run_for(OutputSink& sink, const std::function<Flow(const RunOptions&)>& run, RunOptions options);

}  // namespace burin::preset
