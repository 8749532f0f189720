#pragma once

#include <cstdint>
#include <stop_token>

#include <burin/base/executor.hpp>
#include <burin/geom/box2.hpp>

namespace burin {

/// What can be seen, in model units. A generator refines only until nothing bigger than `tolerance` is left to show and
/// leaves out what lies outside `box`; the points it does give are bit-equal to a subset of the full run.
struct View {
  Box2 box = Box2::everything();
  double tolerance = 0.0;  ///< 0: every point
  bool is_limited() const { return tolerance > 0.0; }
};

/// What a generator draws under, besides its parameters.
struct DrawContext {
  std::uint64_t seed = 0;
  View view{};
  Vec2 origin{};             ///< points are emitted, and view.box counted, from here: a deep zoom puts it into what it
                             ///< shows, where numbers are finest
  double mm_per_unit = 1.0;  ///< millimetres of the page in one model unit
  std::stop_token stop{};
  const Executor* executor = nullptr;  ///< null: serial
};

/// What a run will emit, known before the work.
struct Forecast {
  double points = 0.0;        ///< saturates at infinity instead of overflowing
  double asked_points = 0.0;  ///< what the parameters ask for before the view cuts it
  bool exact = true;          ///< else an upper bound
};

}  // namespace burin
