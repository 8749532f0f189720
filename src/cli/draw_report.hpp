#pragma once

#include <string>
#include <string_view>

#include <cli/console.hpp>
#include <cli/draw_output.hpp>
#include <cli/draw_run.hpp>
#include <cli/origin.hpp>

namespace burin::cli {

/// "koch.svg: 1,234 points drawn of 5,678 asked, 9 skipped; 10,123 bytes", for one output.
std::string output_report(const OutputJob& job, const OutputCounts& counts);

/// Page, pens and seed in a few lines, the same for all outputs; `verbose` adds layers and data files.
std::string piece_report(const preset::Plan& plan, const ReadPiece& piece, bool verbose);

/// The problems of a drawing that failed, on stderr; returns its exit code. `command`: whose help tells more.
ExitCode tell_problems(const DrawOutcome& outcome, std::string_view command, const Console& console);

}  // namespace burin::cli
