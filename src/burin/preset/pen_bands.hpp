#pragma once

#include <cstddef>
#include <cstdint>

#include <burin/path/decorators.hpp>
#include <burin/path/stroke_pieces.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// Lets through the parts of the strokes that one band of a PenChoice draws, cut where the band changes: at every
/// vertex and, in between, by bisection to 2^-30 of an edge, looking at least every half millimetre. Points come and go
/// in model units. O(1) memory.
class PenBand final : public Decorator {
 public:
  /// `choice` must outlive the sink.
  PenBand(PathSink& next, const PenChoice& choice, std::size_t band, const primitives::Setting& setting);

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;

 private:
  Flow edge(Vec2 from, Vec2 to);
  Flow finish_contour();
  bool inside(Vec2 point, Vec2 direction) const;

  const PenChoice& choice_;
  std::size_t band_;
  primitives::Setting setting_;
  primitives::PositionUse used_;
  StrokePieces pieces_;

  PathHead head_{};
  primitives::PathPlace place_{};
  std::uint64_t next_path_ = 0;
  std::uint64_t edge_index_ = 0;
  std::uint64_t contour_points_ = 0;
  Vec2 first_{};
  Vec2 last_{};
};

}  // namespace burin::preset
