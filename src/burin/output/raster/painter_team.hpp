#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <burin/base/executor.hpp>
#include <burin/output/raster/painter.hpp>

namespace burin::output::raster {

/// Who may draw at a time.
struct Workers {
  const Executor* executor = nullptr;  ///< not null when there are several
  std::size_t count = 1;
};

/// One painter, or several at a time that share the rows of a part of the page. The picture is the same: what a layer's
/// ink is at a place depends on nothing but the layer.
class PainterTeam final : public PathSink {
 public:
  /// One worker: a single painter. Else a drawing is kept in pieces of up to 32,768 points, each of which is drawn by
  /// all; one that is no longer than that is drawn by one. The rest as for Painter; the executor must outlive the team.
  PainterTeam(const Sheet& sheet, double dots_per_mm, const PixelBox& part, const Kernel& kernel,
              const Workers& workers);

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Vec2* room_for(std::size_t count) override;
  Flow contour() override;
  Flow end() override;

  /// Completes the last layer.
  void finish();

  /// After finish(): Picture's row j.
  template <class Blank, class Pixels>
  void visit_row(int j, const Blank& blank, const Pixels& pixels) const {
    picture_of(j).visit_row(j, blank, pixels);
  }
  /// After finish(): every colour that shows, some of them many times, always in the same order, until visit(span)
  /// returns false.
  template <class Visit>
  bool visit_colours(const Visit& visit) const {
    for (int j = part_.top; j < part_.bottom; j += MaskTiles::height) {
      if (!picture_of(j).visit_colours(j, visit)) return false;
    }
    return true;
  }

 private:
  /// A call of PathSink.
  struct Call {
    enum class What : std::uint8_t { begin, points, contour, end } what;
    PathHead head{};
    std::size_t count = 0;  ///< of points
  };

  const Picture& picture_of(int j) const {
    return painters_[static_cast<std::size_t>((j >> RowShare::stripe_bits) % static_cast<int>(painters_.size()))]
        ->picture();
  }
  bool keeps_calls() const { return workers_.count > 1; }
  void hire(std::size_t count, const Executor& executor);
  void paint_kept();
  void repeat_calls(PathSink& to) const;

  const Sheet& sheet_;
  double dots_per_mm_;
  PixelBox part_;
  const Kernel& kernel_;
  Workers workers_;
  std::vector<std::unique_ptr<Painter>> painters_;
  std::vector<Call> calls_;
  std::vector<Vec2> points_;  ///< the first point_count_ are kept; behind them is room
  std::size_t point_count_ = 0;
};

}  // namespace burin::output::raster
