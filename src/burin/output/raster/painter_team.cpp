#include <algorithm>
#include <bit>

#include <burin/output/raster/painter_team.hpp>

namespace burin::output::raster {

namespace {

/// Of a piece of the drawing: worth a millisecond or more of work, and small enough to stay in a processor's cache.
constexpr std::size_t points_at_once = 1U << 15U;
/// What generators write at a time fits beside what is kept: memory that grows is cleared and copied.
constexpr std::size_t least_room = points_at_once + (1U << 14U);
constexpr std::size_t calls_at_once = 1U << 14U;
/// Each has to walk along all points.
constexpr std::size_t most_painters = 16;

}  // namespace

PainterTeam::PainterTeam(const Sheet& sheet, double dots_per_mm, const PixelBox& part, const Kernel& kernel,
                         const Workers& workers)
    : sheet_(sheet), dots_per_mm_(dots_per_mm), part_(part), kernel_(kernel), workers_(workers) {
  if (!keeps_calls()) hire(1, SerialExecutor());
}

Flow PainterTeam::begin(const PathHead& head) {
  if (!keeps_calls()) return painters_.front()->begin(head);
  calls_.push_back({Call::What::begin, head});
  return Flow::go;
}

Flow PainterTeam::points(std::span<const Vec2> points) {
  if (!keeps_calls()) return painters_.front()->points(points);
  calls_.push_back({Call::What::points, {}, points.size()});
  Vec2* const room = room_for(points.size());
  if (points.data() != room) std::copy(points.begin(), points.end(), room);
  point_count_ += points.size();
  if (point_count_ >= points_at_once || calls_.size() >= calls_at_once) paint_kept();
  return Flow::go;
}

Vec2* PainterTeam::room_for(std::size_t count) {
  if (!keeps_calls()) return nullptr;
  if (points_.size() < point_count_ + count) points_.resize(std::max(point_count_ + count, least_room));
  return points_.data() + point_count_;
}

Flow PainterTeam::contour() {
  if (!keeps_calls()) return painters_.front()->contour();
  calls_.push_back({Call::What::contour});
  return Flow::go;
}

Flow PainterTeam::end() {
  if (!keeps_calls()) return painters_.front()->end();
  calls_.push_back({Call::What::end});
  return Flow::go;
}

void PainterTeam::finish() {
  if (painters_.empty()) hire(1, SerialExecutor());
  if (painters_.size() == 1) {
    repeat_calls(*painters_.front());
    painters_.front()->finish();
    return;
  }
  workers_.executor->run(painters_.size(), [this](std::size_t k) {
    repeat_calls(*painters_[k]);
    painters_[k]->finish();
  });
}

/// Pre: count is a power of two.
void PainterTeam::hire(std::size_t count, const Executor& executor) {
  painters_.resize(count);
  // At the same time, for memory that is new takes a while.
  executor.run(count, [&](std::size_t k) {
    const RowShare share{static_cast<int>(k), static_cast<int>(count - 1)};
    painters_[k] = std::make_unique<Painter>(sheet_, dots_per_mm_, part_, kernel_, share);
  });
}

void PainterTeam::paint_kept() {
  if (painters_.empty()) hire(std::bit_ceil(std::min(workers_.count, most_painters)), *workers_.executor);
  workers_.executor->run(painters_.size(), [this](std::size_t k) { repeat_calls(*painters_[k]); });
  calls_.clear();
  point_count_ = 0;
}

void PainterTeam::repeat_calls(PathSink& to) const {
  std::span<const Vec2> rest(points_);
  // A painter never stops a drawing.
  for (const Call& call : calls_) {
    switch (call.what) {
      case Call::What::begin:
        static_cast<void>(to.begin(call.head));
        break;
      case Call::What::points:
        static_cast<void>(to.points(rest.first(call.count)));
        rest = rest.subspan(call.count);
        break;
      case Call::What::contour:
        static_cast<void>(to.contour());
        break;
      case Call::What::end:
        static_cast<void>(to.end());
        break;
    }
  }
}

}  // namespace burin::output::raster
