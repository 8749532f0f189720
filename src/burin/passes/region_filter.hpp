#pragma once

#include <vector>

#include <burin/passes/areas.hpp>
#include <burin/passes/cut_strokes.hpp>
#include <burin/passes/regions.hpp>
#include <burin/path/decorators.hpp>

namespace burin::passes {

enum class Keep : bool { outside, inside };

/// Lets through what lies outside the regions, or inside them. Lines are cut where they cross a border, not painted
/// over; `border` says to which side those along it belong. Fills become the part of their area that is left.
///
/// Occlusion is this: an item is hidden by the regions of later items. Memory: as CutStrokes; one whole filled path.
class RegionFilter final : public Decorator {
 public:
  /// All regions count.
  RegionFilter(PathSink& next, const Regions& regions, Keep keep, Border border)
      : Decorator(next), regions_(regions), keep_(keep), border_(border), strokes_(next) {}

  /// Only the regions of items after the one that passes count: `item`, kept by an ItemCounter.
  RegionFilter(PathSink& next, const Regions& regions, Keep keep, Border border, const Regions::Item& item)
      : Decorator(next), regions_(regions), keep_(keep), border_(border), item_(&item), strokes_(next) {}

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;

 private:
  Flow stroke_to(Vec2 to);
  Flow finish_stroke();
  Flow fill();

  const Regions& regions_;
  Keep keep_;
  Border border_;
  const Regions::Item* item_ = nullptr;  ///< null: all regions count
  CutStrokes strokes_;
  Regions::Query query_;
  std::vector<Segment> left_;

  PathHead head_{};
  Regions::Item first_item_ = 0;
  bool has_point_ = false;
  std::vector<std::vector<Vec2>> contours_;  ///< of a fill
};

}  // namespace burin::passes
