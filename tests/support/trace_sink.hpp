#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::test {

/// Writes down the calls it gets: "begin 0 ink stroke closed 2; points 1,2 3,4; contour; end; ". After `calls` calls it
/// answers Flow::stop.
class TraceSink final : public PathSink {
 public:
  explicit TraceSink(std::size_t calls = std::numeric_limits<std::size_t>::max()) : calls_left_(calls) {}

  Flow begin(const PathHead& head) override {
    constexpr const char* roles[] = {"ink", "mask", "ink_and_mask"};
    constexpr const char* paints[] = {"stroke", "fill_nonzero", "fill_evenodd"};
    return noted(fmt::format("begin {} {} {} {} {}", head.layer, roles[static_cast<int>(head.role)],
                             paints[static_cast<int>(head.paint)], head.closed ? "closed" : "open", head.level));
  }
  Flow points(std::span<const Vec2> points) override {
    std::string call = "points";
    for (const Vec2 p : points) call += ' ' + shortest_text(p.x) + ',' + shortest_text(p.y);
    return noted(call);
  }
  Flow contour() override { return noted("contour"); }
  Flow end() override { return noted("end"); }

  const std::string& trace() const { return trace_; }

 private:
  Flow noted(const std::string& call) {
    trace_ += call + "; ";
    if (calls_left_ > 0) --calls_left_;
    return calls_left_ == 0 ? Flow::stop : Flow::go;
  }

  std::string trace_;
  std::size_t calls_left_;
};

}  // namespace burin::test
