#pragma once

#include <string>
#include <vector>

#include <burin/curves/base_shape.hpp>

namespace burin::curves {

/// The lines of another curve, for a base: { family = "two-point", motif = "koch", levels = 3 }, every point of it in
/// its own units, as its own `seed` has it.
struct CurveSource {
  std::vector<Polyline> polylines;
};

/// The most points that a base takes of a curve.
inline constexpr double most_source_points = 1e6;

}  // namespace burin::curves

/// A curve as a layer has it, with `seed` (0) besides. Problems: the family's own; more than most_source_points points.
template <>
struct burin::params::ValueType<burin::curves::CurveSource> {
  static std::string name() { return "curve"; }
  static bool read(const Value& value, burin::curves::CurveSource& source, ReadContext& context);
  static std::string text(const burin::curves::CurveSource&) { return {}; }
};
