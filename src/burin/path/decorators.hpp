#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include <burin/geom/affine2.hpp>
#include <burin/geom/box2.hpp>
#include <burin/path/path_sink.hpp>

/// Sinks that hold a sink: each does one thing to what passes through. All are O(1) in memory.
namespace burin {

/// Passes every call on but room_for, for most change the points or keep them; the others override what they change.
class Decorator : public PathSink {
 public:
  explicit Decorator(PathSink& next) : next_(next) {}
  Flow begin(const PathHead& head) override { return next_.begin(head); }
  Flow points(std::span<const Vec2> points) override { return next_.points(points); }
  Flow contour() override { return next_.contour(); }
  Flow end() override { return next_.end(); }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override {
    return next_.place(head, figure, at);
  }

 protected:
  PathSink& next() { return next_; }

 private:
  PathSink& next_;
};

/// Maps every point, for example by page_from_model.
class Mapped final : public Decorator {
 public:
  Mapped(PathSink& next, const Affine2& map) : Decorator(next), map_(map) {}
  Flow points(std::span<const Vec2> points) override;
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override {
    return next().place(head, figure, map_ * at);
  }

 private:
  Affine2 map_;
  std::vector<Vec2> mapped_;  ///< kept: most strokes are short, and there are many
};

/// Gives every path the layer, role and level of `head`; what is closed and filled stays as it comes.
class Relabelled final : public Decorator {
 public:
  Relabelled(PathSink& next, const PathHead& head) : Decorator(next), head_(head) {}
  Flow begin(const PathHead& head) override;
  Vec2* room_for(std::size_t count) override { return next().room_for(count); }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;

 private:
  PathHead relabelled(const PathHead& head) const;

  PathHead head_;
};

/// Puts every path on one sheet layer, painted its way; what is closed, its role and its level stay as they come.
class Painted final : public Decorator {
 public:
  Painted(PathSink& next, LayerId layer, Paint paint) : Decorator(next), layer_(layer), paint_(paint) {}
  Flow begin(const PathHead& head) override { return next().begin(painted(head)); }
  Vec2* room_for(std::size_t count) override { return next().room_for(count); }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override {
    return next().place(painted(head), figure, at);
  }

 private:
  PathHead painted(PathHead head) const {
    head.layer = layer_;
    head.paint = paint_;
    return head;
  }

  LayerId layer_;
  Paint paint_;
};

/// Counts paths and points, those of placed figures too, and passes them on.
class Counted final : public Decorator {
 public:
  using Decorator::Decorator;
  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Vec2* room_for(std::size_t count) override { return next().room_for(count); }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;
  std::uint64_t paths() const { return paths_; }
  std::uint64_t point_count() const { return points_; }

 private:
  std::uint64_t paths_ = 0;
  std::uint64_t points_ = 0;
};

/// Ends the drawing with Flow::stop as soon as a stop is requested.
class Stoppable final : public Decorator {
 public:
  Stoppable(PathSink& next, std::stop_token stop) : Decorator(next), stop_(std::move(stop)) {}
  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Vec2* room_for(std::size_t count) override { return next().room_for(count); }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;

 private:
  std::stop_token stop_;
};

/// Holds everyone upstream to the contract of PathSink: call order, finite points, no empty contour, ascending layers.
/// A breach is a bug and aborts. Costs a test per point; on in tests and debug builds.
class Checked final : public Decorator {
 public:
  using Decorator::Decorator;
  ~Checked() override;
  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Vec2* room_for(std::size_t count) override { return next().room_for(count); }
  Flow contour() override;
  Flow end() override;
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;

 private:
  Flow noted(Flow flow);

  bool in_path_ = false;
  bool stopped_ = false;
  std::size_t contour_points_ = 0;
  LayerId last_layer_ = 0;
};

/// Takes a drawing and keeps only its bounding box and whether every point is finite: the one sink that may meet
/// others.
class BoundsSink final : public PathSink {
 public:
  Flow begin(const PathHead&) override { return Flow::go; }
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override { return Flow::go; }
  Flow end() override { return Flow::go; }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;
  const Box2& box() const { return box_; }
  bool finite() const { return finite_; }

 private:
  Box2 box_;
  bool finite_ = true;
};

}  // namespace burin
