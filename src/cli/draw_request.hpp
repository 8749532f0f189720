#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/burin.hpp>
#include <burin/path/back_end.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/plan.hpp>
#include <cli/options.hpp>
#include <cli/series.hpp>

namespace burin::cli {

/// One file to write. An empty path: the preset's name with the format as its suffix. Braces in it are placeholders,
/// which series_outputs.hpp fills in before anything is opened.
struct RequestedOutput {
  std::string path;
  const BackEnd* back_end = nullptr;
};

/// What `burin draw` was asked for, checked as far as that goes without the preset.
struct DrawRequest {
  std::string command = "burin draw";  ///< where problems of the command line are
  std::string preset;
  std::vector<RequestedOutput> outputs;
  preset::Overrides overrides;  ///< of all results; a single --seed too
  SeriesRequest series;
  int threads = 0;  ///< 0: all cores
  int decimals = 3;
  double dots_per_inch = 300.0;
  std::optional<double> longer_side_px;  ///< instead of dots_per_inch
  std::optional<preset::PageWindow> view;
  std::string view_text;  ///< as it was written
  bool paper = false;
  bool defs = false;
  bool all_points = false;
  double max_points = default_max_points;
  double max_memory_mb = default_max_memory_bytes / 1e6;
  std::vector<std::string> only;
  std::vector<std::string> skip;
  bool quiet = false;
  bool verbose = false;

  bool writes_stdout() const;
};

std::span<const OptionRow> draw_options();

/// The back end to take for a format when the command line names none.
struct PreferredBackEnd {
  std::string format;  ///< empty: none
  std::string back_end;
};

/// Everything that is wrong with the command line at once, as `command` tells it.
Result<DrawRequest> read_draw_request(const Arguments& arguments, const std::string& command = "burin draw",
                                      const PreferredBackEnd& preferred = {});

/// The choices a back end looks at, for a page of this size.
OutputOptions output_options(const DrawRequest& request, const Page& page);

}  // namespace burin::cli
