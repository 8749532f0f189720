#pragma once

#include <cstdint>
#include <string>

#include <burin/geom/vec2.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::cli {

/// A line of letters on a page, in mm, y down.
struct TextLine {
  enum class From : std::uint8_t { left, middle, right };

  std::string text;
  Vec2 at;  ///< on the baseline, where the text begins, has its middle or ends
  From from = From::left;
  double height_mm = 2.0;  ///< of the capitals
  double room_mm = 100.0;  ///< a longer line is made smaller
};

/// How much of its room it takes.
double width_mm(const TextLine& line);

/// Strokes of single lines.
[[nodiscard]] Flow draw_line(const TextLine& line, const PathHead& head, PathSink& sink);

}  // namespace burin::cli
