#pragma once

#include <optional>
#include <vector>

#include <burin/output/raster/dashes.hpp>
#include <burin/output/raster/picture.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::output::raster {

/// Draws the layers of a sheet on its share of a part of the page. A layer is one union of samples, laid over the
/// picture when it is complete, so that its lines do not darken each other.
class Painter final : public PathSink {
 public:
  /// `sheet` must outlive the painter. Pre: `part` begins at whole tiles, and the page has at most 2^17 pixels a side.
  Painter(const Sheet& sheet, double dots_per_mm, const PixelBox& part, const Kernel& kernel, RowShare share);

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;

  /// Completes the last layer.
  void finish();
  /// Once all layers are complete.
  const Picture& picture() const { return picture_; }

 private:
  bool strokes() const { return head_.paint == Paint::stroke; }
  void enter_layer(LayerId layer);
  void leave_layer();
  void begin_contour();
  void end_contour();

  const Sheet& sheet_;
  double dots_per_mm_;
  Box2 page_;  ///< in pixels
  Ink ink_;
  Picture picture_;
  PathStroker stroker_;
  Dashes dashes_;
  PolygonFill fill_;
  std::optional<LayerId> layer_;
  PathHead head_;
  std::vector<Vec2> polygon_;  ///< the contour of a fill, in pixels
  std::vector<Vec2> spare_;
  std::vector<Point> rounded_;
};

}  // namespace burin::output::raster
