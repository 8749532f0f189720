#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/curves/limit_facts.hpp>
#include <burin/measure/box_dimension.hpp>
#include <burin/measure/page_ink.hpp>
#include <burin/measure/path_figures.hpp>
#include <burin/path/recording.hpp>
#include <cli/draw_request.hpp>

namespace burin::cli {

/// What is known of a layer's curve beside its points.
struct KnownCurve {
  std::string layer;
  curves::LimitFacts facts;
};

/// A drawing as it lies on its page.
struct MeasuredPage {
  double width_mm = 0.0;
  double height_mm = 0.0;
  measure::PathFigures paths;  ///< in millimetres
  measure::PageInk ink;
};

/// A drawing to be measured: the points of a file in its own units, or those of a preset in model units, as its CSV has
/// them.
struct MeasuredDrawing {
  std::string name;
  std::string units;  ///< what lengths are counted in, for people
  Recording drawing;
  std::vector<KnownCurve> known;     ///< of a preset's layers
  std::optional<MeasuredPage> page;  ///< of a preset
};

/// Whether the word names a file of points: a CSV or an SVG file.
bool is_points_file(std::string_view word);

/// Reads what the request's preset names: a CSV file (a path is closed when `closed`, or when it ends where it
/// began), an SVG file, or else a preset
/// with its knobs, keys and seed set and the layers asked for.
Result<MeasuredDrawing> read_measured_drawing(const DrawRequest& request, bool closed);

}  // namespace burin::cli
