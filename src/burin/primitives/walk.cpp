#include <burin/primitives/walk.hpp>

namespace burin::primitives {

void Walk::begin(bool closed) {
  closed_ = closed;
  count_ = 0;
}

Flow Walk::points(std::span<const Vec2> points) {
  for (const Vec2 p : points) {
    if (point(p) == Flow::stop) return Flow::stop;
  }
  return Flow::go;
}

Flow Walk::point(Vec2 p) {
  const std::uint64_t count = count_++;
  if (count == 0) {
    first_ = last_ = p;
    to_next_ = 0.0;
    visited_ = 0;
    return Flow::go;
  }
  const Vec2 from = last_;
  const Vec2 out = p - from;
  const Vec2 in = count == 1 ? out : arrived_;
  if (count == 1) second_ = p;
  last_ = p;
  arrived_ = out;
  if (stops_ != Stops::points) return edge(from, out, count - 1);
  return count == 1 && closed_ ? Flow::go : visit_({from, in, out, count - 1});
}

Flow Walk::finish() {
  const std::uint64_t count = count_;
  count_ = 0;
  if (count == 0) return Flow::go;
  if (count == 1) return visit_({first_, {}, {}, 0});
  const Vec2 closing = first_ - last_;
  if (stops_ != Stops::points) return closed_ ? edge(last_, closing, count - 1) : Flow::go;
  if (!closed_) return visit_({last_, arrived_, arrived_, count - 1});
  if (visit_({last_, arrived_, closing, count - 1}) == Flow::stop) return Flow::stop;
  return visit_({first_, closing, second_ - first_, 0});
}

Flow Walk::edge(Vec2 from, Vec2 along, std::uint64_t index) {
  if (stops_ == Stops::lengths) return visit_lengths(from, along);
  return visit_({from + 0.5 * along, along, along, index});
}

/// The end of a closed path is its beginning, where a place is already: hence "<", and a hair for rounding.
Flow Walk::visit_lengths(Vec2 from, Vec2 along) {
  constexpr double hair = 1e-9;
  const double size = length(along);
  while (to_next_ < size - hair * step_) {
    if (visit_({from + (to_next_ / size) * along, along, along, visited_++}) == Flow::stop) return Flow::stop;
    to_next_ += step_;
  }
  to_next_ -= size;
  return Flow::go;
}

}  // namespace burin::primitives
