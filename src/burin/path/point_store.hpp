#pragma once

#include <cstddef>
#include <span>

#include <burin/path/path_sink.hpp>

namespace burin {

/// Keeps the points of a drawing, contour after contour, in memory of the caller's. Generators that fill spans write
/// them to their place at once: a Koch curve of a million points takes about twice what clearing that memory would.
///
///   std::vector<Vec2> memory(static_cast<std::size_t>(family->forecast(parameters, context, 1e8).points));
///   PointStore store(memory);
///   if (family->draw(parameters, context, store) == Flow::go) use(store.stored());
///
/// Stops the drawing when a point does not fit. Where the paths and contours begin, it does not tell: a Recorder does.
class PointStore final : public PathSink {
 public:
  explicit PointStore(std::span<Vec2> memory) : memory_(memory) {}

  Flow begin(const PathHead&) override { return Flow::go; }
  /// As many as fit.
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override { return Flow::go; }
  Flow end() override { return Flow::go; }
  Vec2* room_for(std::size_t count) override;

  /// So far. The memory behind them may have been written to.
  std::span<const Vec2> stored() const { return memory_.first(count_); }

 private:
  std::span<Vec2> memory_;
  std::size_t count_ = 0;
};

}  // namespace burin
