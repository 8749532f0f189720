#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <burin/curves/line_art/composition.hpp>
#include <burin/curves/line_art/neighbours.hpp>
#include <burin/curves/line_art/tone_field.hpp>

namespace burin::curves::line_art {

/// Makes strokes of polylines, one after another. With spacing or tone it remembers what it made: memory follows the
/// strokes; else it needs none.
class Strokes {
 public:
  Strokes(const Composition& composition, Meet meet, std::uint64_t seed);

  /// The strokes that polyline `line` leaves, valid until the next call; `points` is worked on. Lines come in order.
  /// `depth`: that of Spot.
  std::span<const std::vector<Vec2>> of(std::uint64_t line, std::vector<Vec2>& points, double depth);
  /// The kind of the strokes made last.
  std::uint16_t kind() const { return kind_; }
  /// Whether the budget is used up: no later line leaves a stroke.
  bool spent() const { return left_ <= 0.0; }

 private:
  /// Cuts the polyline at the shapes: the parts that lie where strokes may.
  void cut_by_shapes(const std::vector<Vec2>& points);
  bool may_be_at(Vec2 p) const;
  /// Cuts a part where it meets strokes or full tone.
  void cut_by_strokes(const std::vector<Vec2>& part);
  std::vector<Vec2>& fresh(std::vector<std::vector<Vec2>>& list, std::size_t& count);
  /// Keeps the last stroke, or takes it back with its tone when it is too short.
  void finish_stroke(std::size_t tone_mark);

  Composition composition_;
  Meet meet_;
  std::uint64_t seed_;
  std::optional<Neighbours> neighbours_;
  std::optional<ToneField> tone_;
  double left_ = std::numeric_limits<double>::infinity();  ///< of the budget
  std::uint16_t kind_ = 0;

  // Lists that keep their memory from line to line, with how many of their items are in use.
  std::vector<std::vector<Vec2>> parts_;
  std::size_t part_count_ = 0;
  std::vector<std::vector<Vec2>> strokes_;
  std::size_t stroke_count_ = 0;
  bool is_cut_ = false;
  std::vector<Vec2> spare_;
  std::vector<double> crossings_;
};

}  // namespace burin::curves::line_art
