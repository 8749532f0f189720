#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include <burin/path/path_sink.hpp>
#include <burin/primitives/position.hpp>

namespace burin::primitives {

/// Where a walk along a path stops.
enum class Stops : std::uint8_t {
  points,     ///< at every point; the first of a closed path comes last, when its arriving edge is known
  midpoints,  ///< in the middle of every edge
  lengths,    ///< at the beginning and whenever a length has been walked
};

/// Walks along contours whose points come one after another and visits places on them. O(1) memory.
class Walk {
 public:
  using Visit = std::function<Flow(const Frame&)>;

  /// `step` is the length between two places, in the points' units, above 0; for Stops::lengths alone.
  Walk(Stops stops, double step, Visit visit) : stops_(stops), step_(step), visit_(std::move(visit)) {}

  void begin(bool closed);
  Flow points(std::span<const Vec2> points);
  /// Ends the contour; another of the same path may follow.
  Flow finish();

 private:
  Flow point(Vec2 p);
  Flow edge(Vec2 from, Vec2 along, std::uint64_t index);
  Flow visit_lengths(Vec2 from, Vec2 along);

  Stops stops_;
  double step_;
  Visit visit_;

  bool closed_ = false;
  std::uint64_t count_ = 0;  ///< points of this contour so far
  Vec2 first_;
  Vec2 second_;
  Vec2 last_;
  Vec2 arrived_;               ///< the edge to the last point
  double to_next_ = 0.0;       ///< length to walk until the next place
  std::uint64_t visited_ = 0;  ///< places of this contour by length
};

}  // namespace burin::primitives
