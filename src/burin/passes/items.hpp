#pragma once

#include <burin/passes/regions.hpp>
#include <burin/path/decorators.hpp>

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

/// Takes a drawing and adds what its closed paths enclose to regions, each path to its item. A stroke's rule is
/// nonzero.
class RegionRecorder final : public PathSink {
 public:
  /// `item`: of what passes, kept by an ItemCounter. Both outlive the recorder.
  RegionRecorder(Regions& regions, const Regions::Item& item) : regions_(regions), item_(item) {}

  Flow begin(const PathHead& head) override {
    head_ = head;
    contours_.assign(1, {});
    return Flow::go;
  }
  Flow points(std::span<const Vec2> points) override {
    if (is_closed()) contours_.back().insert(contours_.back().end(), points.begin(), points.end());
    return Flow::go;
  }
  Flow contour() override {
    contours_.emplace_back();
    return Flow::go;
  }
  Flow end() override {
    if (is_closed()) {
      regions_.add(item_, contours_, head_.paint == Paint::stroke ? Paint::fill_nonzero : head_.paint);
    }
    return Flow::go;
  }

 private:
  bool is_closed() const { return head_.closed || head_.paint != Paint::stroke; }

  Regions& regions_;
  const Regions::Item& item_;
  PathHead head_{};
  std::vector<std::vector<Vec2>> contours_;
};

}  // namespace burin::passes
