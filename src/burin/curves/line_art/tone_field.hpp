#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include <burin/curves/line_art/cells.hpp>
#include <burin/curves/line_art/values.hpp>

namespace burin::curves::line_art {

/// How much line each part of the plane may take until it has its tone. Strokes that lie as chance will cover the share
/// 1 - exp(-w L) of the paper with L of length an area and w of width (Boolean model; Stoyan, Kendall, Mecke), so a
/// cell of tone c takes -ln(1 - c) / w of length an area.
class ToneField {
 public:
  /// Pre: tone is given, pen_width > 0.
  ToneField(const FieldFunction& tone, double pen_width);

  /// Draws an edge if every cell on its way can take it; else nothing changes.
  bool take(Vec2 a, Vec2 b);

  /// Counts the round ends of a stroke that was drawn: half a disc of the pen at each.
  void add_ends(Vec2 first, Vec2 last);

  /// How many pieces were taken so far, for give_back.
  std::size_t mark() const { return taken_.size(); }
  /// Undoes what was taken since the mark.
  void give_back(std::size_t mark);
  /// What was taken stays.
  void keep() { taken_.clear(); }

 private:
  struct Room {
    double left = 0.0;  ///< length that the cell can take
    double whole = 0.0;
  };
  struct Taken {
    Room* room;
    double length;
  };

  Room& room_at(Vec2 p);
  void draw_in(Room& room, double length);

  FieldFunction tone_;
  double pen_width_;
  double side_;
  std::unordered_map<Cell, Room, CellHash> rooms_;  ///< only looked up: its order is nowhere
  std::vector<Taken> taken_;
};

}  // namespace burin::curves::line_art
