#pragma once

#include <burin/passes/regions.hpp>
#include <burin/path/decorators.hpp>
#include <burin/path/recording.hpp>

namespace burin::passes {

/// Numbers the items that pass, a path or a placed figure each: the same numbers in every replay. Sinks further on read
/// the number of the one that passes.
class ItemCounter final : public Decorator {
 public:
  /// `item` is counted up before each item and must outlive the sink.
  ItemCounter(PathSink& next, Regions::Item& item) : Decorator(next), item_(item) {}

  Flow begin(const PathHead& head) override {
    ++item_;
    return next().begin(head);
  }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override {
    ++item_;
    return next().place(head, figure, at);
  }

 private:
  Regions::Item& item_;
};

/// Makes areas of closed paths: strokes become fills by `rule`, fills stay as they are, open strokes end here.
class ClosedPaths final : public Decorator {
 public:
  ClosedPaths(PathSink& next, Paint rule) : Decorator(next), rule_(rule) {}

  Flow begin(const PathHead& head) override {
    passes_ = head.closed || head.paint != Paint::stroke;
    if (!passes_) return Flow::go;
    PathHead area = head;
    area.closed = true;
    if (head.paint == Paint::stroke) area.paint = rule_;
    return next().begin(area);
  }
  Flow points(std::span<const Vec2> points) override { return passes_ ? next().points(points) : Flow::go; }
  Flow contour() override { return passes_ ? next().contour() : Flow::go; }
  Flow end() override { return passes_ ? next().end() : Flow::go; }
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override {
    return PathSink::place(head, figure, at);
  }

 private:
  Paint rule_;
  bool passes_ = false;
};

/// Takes fills and adds their areas to regions, each path to its item.
class RegionRecorder final : public PathSink {
 public:
  /// `item`: of what passes, kept by an ItemCounter. Both outlive the recorder.
  RegionRecorder(Regions& regions, const Regions::Item& item) : regions_(regions), item_(item) {}

  Flow begin(const PathHead& head) override {
    rule_ = head.paint;
    contours_.assign(1, {});
    return Flow::go;
  }
  Flow points(std::span<const Vec2> points) override {
    contours_.back().insert(contours_.back().end(), points.begin(), points.end());
    return Flow::go;
  }
  Flow contour() override {
    contours_.emplace_back();
    return Flow::go;
  }
  Flow end() override {
    regions_.add(item_, contours_, rule_);
    return Flow::go;
  }

 private:
  Regions& regions_;
  const Regions::Item& item_;
  Paint rule_ = Paint::fill_nonzero;
  std::vector<std::vector<Vec2>> contours_;
};

}  // namespace burin::passes
