#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <burin/curves/two_point/motif.hpp>
#include <burin/geom/box2.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::curves::two_point {

/// What a motif makes of the edge from (0, 0) to (1, 0), y up, and how its sub-edges go on.
struct MotifFigure {
  std::vector<Vec2> path;
  std::vector<std::uint8_t> flip{};     ///< empty, or one for each sub-edge
  std::vector<std::uint8_t> reverse{};  ///< empty, or one for each sub-edge
  std::vector<Vec2> joined{};           ///< empty, or the sub-edges' join points

  friend bool operator==(const MotifFigure&, const MotifFigure&) = default;
};

/// The figures of a motif: one for each stage of by_level and each list of by_edge. Random marks are drawn by the seed.
/// Nothing when a figure leaves the range of numbers.
std::optional<std::vector<MotifFigure>> motif_figures(const Motif& motif, const std::optional<SignRule>& sign,
                                                      std::uint64_t seed);

/// A page for figures, with the pens and layers that draw_motif_figures draws on.
Sheet motif_sheet(const Page& page);

/// Draws the figures in a grid inside `area_mm`, all to one scale. The unit edge is dashed; the motif's edges are full
/// lines with a dot at every vertex. A half arrow on an edge points the way in which the edge is built, its barb on
/// its right, or on its left where the edge is mirrored: each stands for a copy of the whole figure, laid with the half
/// arrow of the dashed edge on it. A thin line goes through the join points. Pre: there is a figure; the sheet is a
/// motif_sheet; the area has a width and a height.
Flow draw_motif_figures(std::span<const MotifFigure> figures, const Box2& area_mm, PathSink& sink);

}  // namespace burin::curves::two_point
