#pragma once

#include <string>
#include <vector>

#include <cli/draw_request.hpp>
#include <cli/preset_library.hpp>
#include <cli/series.hpp>

namespace burin::cli {

/// The series that is asked for, held against the preset. Problems: all that is wrong with the preset when it cannot be
/// read, else those of Series::make.
Result<Series> read_series(const DrawRequest& request, const PresetText& preset);

/// What went wrong with the results, each problem once, with the results that have it.
Problems grouped_problems(const std::vector<Problems>& of_result, const Series& series);

/// What to say when no result changes with the seed: a line, or nothing when only one seed was asked for.
std::string seed_warning(const DrawRequest& request);

}  // namespace burin::cli
