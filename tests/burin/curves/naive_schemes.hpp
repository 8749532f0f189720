#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <burin/base/random.hpp>
#include <burin/geom/affine2.hpp>

/// The schemes of curves.md C to E as they are written there: one level after another, each a whole list.
namespace burin::curves::naive {

using Points = std::vector<Vec2>;

inline Points random_points(std::uint64_t seed, std::size_t count) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({3.0 * uniform_symmetric(seed, 1, i), 3.0 * uniform_symmetric(seed, 2, i)});
  }
  return points;
}

inline Affine2 random_affine(std::uint64_t seed) {
  const auto entry = [&](std::uint64_t i) { return 2.0 * uniform_symmetric(seed, 3, i); };
  return {entry(0), entry(1), entry(2), entry(3), entry(4), entry(5)};
}

inline Points mapped(const Affine2& map, Points points) {
  for (Vec2& p : points) p = map(p);
  return points;
}

inline Points reversed(const Points& points) {
  return {points.rbegin(), points.rend()};
}

inline double size_of(const Points& points) {
  double size = 1.0;
  for (const Vec2 p : points) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  return size;
}

inline double longest_edge(const Points& points, bool closed) {
  double longest = 0.0;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
    longest = std::max(longest, distance(points[i], points[(i + 1) % points.size()]));
  }
  return longest;
}

inline double area_of(const Points& points) {
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) area += 0.5 * cross(points[i], points[(i + 1) % points.size()]);
  return area;
}

inline Points de_rham(const Points& old, double t, bool closed, bool clamped) {
  Points fresh;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < old.size(); ++i) {
    const Vec2 a = old[i];
    const Vec2 b = old[(i + 1) % old.size()];
    fresh.push_back((1 - t) * a + t * b);
    fresh.push_back(t * a + (1 - t) * b);
  }
  if (!closed && clamped) {
    fresh.front() = old.front();
    fresh.back() = old.back();
  }
  return fresh;
}

inline Points four_point(const Points& old, double t, bool closed, const std::string& ends) {
  const std::size_t n = old.size();
  const auto ghost = [&](Vec2 end, Vec2 next) {
    if (ends == "linear") return 2.0 * end - next;
    return ends == "reflect" ? next : end;
  };
  const auto at = [&](std::size_t i_plus_1) {
    if (closed) return old[(i_plus_1 + n - 1) % n];
    if (i_plus_1 == 0) return ghost(old[0], old[1]);
    return i_plus_1 == n + 1 ? ghost(old[n - 1], old[n - 2]) : old[i_plus_1 - 1];
  };
  Points fresh;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    fresh.push_back(old[i]);
    fresh.push_back(0.5 * (1 - t) * (at(i + 1) + at(i + 2)) + 0.5 * t * (at(i) + at(i + 3)));
  }
  if (!closed) fresh.push_back(old[n - 1]);
  return fresh;
}

struct FourParameters {
  double lambda;
  double mu;
  double nu;
  double omega;
};

inline Vec2 even_point(const FourParameters& p, Vec2 a, Vec2 b, Vec2 c) {
  return p.lambda * a + (1 - p.lambda - p.mu) * b + p.mu * c;
}
inline Vec2 odd_point(const FourParameters& p, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 at_b = b - (p.nu * a + (1 - p.nu) * c);
  const Vec2 at_c = c - (p.nu * b + (1 - p.nu) * d);
  return 0.5 * (b + c) + 2 * p.omega * (at_b + at_c);
}

/// N points, ghosts and all, to 2N - 5.
inline Points four_parameter_open(const Points& old, const FourParameters& p) {
  Points fresh;
  for (std::size_t k = 0; k + 2 < old.size(); ++k) {
    fresh.push_back(even_point(p, old[k], old[k + 1], old[k + 2]));
    if (k + 3 < old.size()) fresh.push_back(odd_point(p, old[k], old[k + 1], old[k + 2], old[k + 3]));
  }
  return fresh;
}

inline Points four_parameter_closed(const Points& old, const FourParameters& p) {
  const std::size_t n = old.size();
  Points fresh;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = old[(i + n - 1) % n];
    const Vec2 c = old[(i + 1) % n];
    fresh.push_back(even_point(p, a, old[i], c));
    fresh.push_back(odd_point(p, a, old[i], c, old[(i + 2) % n]));
  }
  return fresh;
}

/// With two ghosts at each side.
inline Points with_ghosts(const Points& points, const std::string& ends) {
  const std::size_t n = points.size();
  Points all;
  for (const double k : {2.0, 1.0}) {
    const auto i = static_cast<std::size_t>(k);
    if (ends == "linear") all.push_back((k + 1) * points[0] - k * points[1]);
    if (ends == "reflect") all.push_back(points[i]);
    if (ends == "replicate") all.push_back(points[0]);
  }
  all.insert(all.end(), points.begin(), points.end());
  for (const double k : {1.0, 2.0}) {
    const auto i = static_cast<std::size_t>(k);
    if (ends == "linear") all.push_back((k + 1) * points[n - 1] - k * points[n - 2]);
    if (ends == "reflect") all.push_back(points[n - 1 - i]);
    if (ends == "replicate") all.push_back(points[n - 1]);
  }
  return all;
}

}  // namespace burin::curves::naive
