#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include <burin/base/bytes.hpp>
#include <burin/base/result.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/path/path_sink.hpp>
#include <burin/path/sheet.hpp>

namespace burin {

/// The space a back end wants its points in.
enum class Space : std::uint8_t {
  page,   ///< millimetres from the page's top left corner, y down
  model,  ///< the generator's own units, y up
};

/// Choices that reach a back end. Each back end documents which it looks at; the tool refuses the others.
struct OutputOptions {
  int decimals = 3;                   ///< places after the point of an SVG coordinate in mm, 0..6
  double dots_per_mm = 300.0 / 25.4;  ///< PNG resolution
  bool paper = false;                 ///< SVG and PDF: draw the paper's colour too
  bool defs = false;                  ///< SVG: write figures once and use them
};

/// A path sink that ends in a ByteSink.
class OutputSink : public PathSink {
 public:
  /// Writes what is still pending and reports write errors, which are kept until here. Call once, after the last run;
  /// not after a Flow::stop that did not come from this sink: the output is then incomplete.
  virtual Result<Done> finish() = 0;

  /// What the next run is for, in page millimetres: outlines that do not come near it may be left out.
  virtual Box2 wanted_part_mm() const { return Box2::everything(); }

  /// Call after each run. True: only a part of the page has been drawn, and the same drawing is wanted again for the
  /// next one.
  virtual bool wants_another_run() { return false; }

  /// Points that were left out since they round onto their predecessor.
  virtual std::uint64_t skipped_points() const { return 0; }
};

/// A row of a table of back ends: a format that burin can write.
struct BackEnd {
  std::string_view name;    ///< "native" or "cairo"
  std::string_view format;  ///< "svg", "pdf", "png", "csv", "dump": also the file suffix
  std::string_view summary;
  Space space;
  bool binary;  ///< refused on a terminal
  /// How far a line may be drawn from where it is, in mm, as this format cannot show it; 0: everything shows.
  double (*tolerance_mm)(const Sheet& sheet, const OutputOptions& options);
  /// What is wrong with this page in this format (too many pixels, for example).
  Result<Done> (*accepts)(const Sheet& sheet, const OutputOptions& options);
  /// About how much memory a drawing of so many points holds until it is finished, in bytes.
  double (*memory_bytes)(double points, const Sheet& sheet, const OutputOptions& options);
  /// `bytes` and `sheet` must outlive the sink.
  std::unique_ptr<OutputSink> (*open)(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options);
};

/// A limit problem when writing this drawing would hold more than `limit_bytes` of memory.
Result<Done> check_memory(const BackEnd& back_end, const Forecast& forecast, const Sheet& sheet,
                          const OutputOptions& options, double limit_bytes);

}  // namespace burin
