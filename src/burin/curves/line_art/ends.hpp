#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>

#include <burin/curves/line_art/draws.hpp>
#include <burin/curves/line_art/line_art.hpp>

namespace burin::curves::line_art {

/// Where the polylines of a boundary model begin and end, in the plane and in space. P are its parameters: from, to,
/// weights, pairing, places, lines, lines_per_start.
template <class P>
class Ends {
 public:
  /// `params` must outlive the ends.
  Ends(const P& params, std::uint64_t seed)
      : params_(params),
        seed_(seed),
        places_((static_cast<std::uint64_t>(params.lines) + per_start() - 1) / per_start()) {}

  /// The pair of ends that a line has, in common with the others of its bundle.
  std::uint64_t bundle_of(std::uint64_t line) const { return line / per_start(); }

  auto start_of(std::uint64_t bundle) const { return place_in(params_.from, start_key(bundle)); }

  template <class Point>
  Point end_of(std::uint64_t bundle, const Point& start) const {
    const auto& target = target_of(bundle);
    PlaceKey key = start_key(bundle);
    if (params_.pairing == Pairing::ordered || params_.pairing == Pairing::crossed) {
      key.turned_round = params_.pairing == Pairing::crossed;
      return place_in(target, key);
    }
    key.x_draw = draws::end_x;
    key.y_draw = draws::end_y;
    key.z_draw = draws::end_z;
    // Of places in a sequence, only the first region's are taken in turn: else they would be paired in order.
    key.places = Places::random;
    Point nearest = place_in(target, key);
    if (params_.pairing == Pairing::random) return nearest;
    constexpr std::uint64_t candidates = 16;
    for (key.candidate = 1; key.candidate < candidates; ++key.candidate) {
      const Point place = place_in(target, key);
      if (length_squared(place - start) < length_squared(nearest - start)) nearest = place;
    }
    return nearest;
  }

 private:
  std::uint64_t per_start() const { return static_cast<std::uint64_t>(params_.lines_per_start); }

  PlaceKey start_key(std::uint64_t bundle) const {
    return {.seed = seed_,
            .x_draw = draws::start_x,
            .y_draw = draws::start_y,
            .z_draw = draws::start_z,
            .index = bundle,
            .count = places_,
            .places = params_.places};
  }

  const auto& target_of(std::uint64_t bundle) const {
    const auto& targets = params_.to.all;
    if (targets.size() == 1) return targets.front();
    const double u = uniform(seed_, draws::target, bundle);
    if (params_.weights.empty()) return targets[static_cast<std::size_t>(u * static_cast<double>(targets.size()))];
    double left = u * std::accumulate(params_.weights.begin(), params_.weights.end(), 0.0);
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (params_.weights[i] == 0.0) continue;
      chosen = i;
      left -= params_.weights[i];
      if (left < 0.0) break;
    }
    return targets[chosen];
  }

  const P& params_;
  std::uint64_t seed_;
  std::uint64_t places_;  ///< pairs of ends
};

}  // namespace burin::curves::line_art
