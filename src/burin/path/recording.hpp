#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <burin/geom/box2.hpp>
#include <burin/path/path_sink.hpp>

namespace burin {

/// A drawing kept in memory: flat points, contours as index ranges, paths as contour ranges. 16 bytes a point.
class Recording {
 public:
  struct Path {
    PathHead head;
    std::size_t first_contour = 0;
    std::size_t contour_count = 0;
  };
  struct Contour {
    std::size_t first_point = 0;
    std::size_t point_count = 0;
  };

  bool empty() const { return paths_.empty(); }
  const std::vector<Path>& paths() const { return paths_; }
  const std::vector<Vec2>& all_points() const { return points_; }
  std::span<const Contour> contours(const Path& path) const;
  std::span<const Vec2> points(const Contour& contour) const;
  Box2 bounds() const;

 private:
  friend class Recorder;
  std::vector<Vec2> points_;
  std::vector<Contour> contours_;
  std::vector<Path> paths_;
};

/// A small drawing in its own units that is put on the page many times.
class Figure {
 public:
  explicit Figure(Recording drawing);
  const Recording& drawing() const { return drawing_; }
  const Box2& bounds() const { return bounds_; }
  /// The same for all figures of the same points; by chance, one time in 2^64, for others too.
  std::uint64_t fingerprint() const { return fingerprint_; }
  /// Whether both draw the same: paths, contours and points, whatever the layers.
  bool looks_like(const Figure& other) const;

 private:
  Recording drawing_;
  Box2 bounds_;
  std::uint64_t fingerprint_ = 0;
};

/// Stream to store. Memory grows with the drawing.
class Recorder final : public PathSink {
 public:
  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;

  const Recording& recording() const { return recording_; }
  Recording take() { return std::move(recording_); }

 private:
  Recording recording_;
};

/// Store to stream.
Flow replay(const Recording& recording, PathSink& sink);

}  // namespace burin
