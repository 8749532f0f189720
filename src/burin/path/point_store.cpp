#include <algorithm>

#include <burin/path/point_store.hpp>

namespace burin {

Flow PointStore::points(std::span<const Vec2> points) {
  const std::span<Vec2> free = memory_.subspan(count_);
  const std::span<const Vec2> fitting = points.first(std::min(points.size(), free.size()));
  // What was written into the room that was lent is there already.
  if (fitting.data() != free.data()) std::copy(fitting.begin(), fitting.end(), free.begin());
  count_ += fitting.size();
  return fitting.size() == points.size() ? Flow::go : Flow::stop;
}

Vec2* PointStore::room_for(std::size_t count) {
  return count <= memory_.size() - count_ ? memory_.data() + count_ : nullptr;
}

}  // namespace burin
