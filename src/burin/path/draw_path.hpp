#pragma once

#include <span>
#include <vector>

#include <burin/path/path_sink.hpp>

namespace burin {

/// Draws one path of these contours, in order. Pre: there is a contour, and none is empty.
[[nodiscard]] inline Flow draw_path(PathSink& sink, const PathHead& head, std::span<const std::vector<Vec2>> contours) {
  if (sink.begin(head) == Flow::stop) return Flow::stop;
  bool first = true;
  for (const std::vector<Vec2>& contour : contours) {
    if (!first && sink.contour() == Flow::stop) return Flow::stop;
    first = false;
    if (sink.points(contour) == Flow::stop) return Flow::stop;
  }
  return sink.end();
}

}  // namespace burin
