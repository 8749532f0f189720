#pragma once

#include <string>
#include <string_view>

#include <burin/base/bytes.hpp>
#include <burin/base/result.hpp>
#include <burin/output/back_ends.hpp>
#include <burin/path/back_end.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/plan.hpp>

/// The front door of the library: from the text of a preset to a drawing.
///
///   const auto plan = burin::load({"snowflake.toml", text}, {.knobs = {{"levels", "3"}}, .seed = 7});
///   if (!plan) return fail(burin::problems_text(plan.problems()));   // file:line:col: error: ...
///   const auto svg = burin::to_svg(*plan);                           // Result<std::string>
///   plan->run(sink, {});                                             // or into a PathSink: a Recorder, a PointStore,
///                                                                   // or one of your own
///
/// Nothing here opens a file, reads a clock or keeps state. A Plan is const and can be drawn from several threads.
namespace burin {

/// What a program may emit unless it says otherwise; the tool's --max-points.
inline constexpr double default_max_points = 5e7;
/// And how much memory, in bytes; the tool's --max-memory.
inline constexpr double default_max_memory_bytes = 2e9;

/// The ReadFile of programs whose presets use no data files: every name is a problem.
Result<std::string> no_files(std::string_view name);

/// Reads a preset with its knobs, seed and page changed as asked, and fits it to its page. All problems come at once.
/// The plan's origin has the preset's title, author and summary, and its text as the record.
Result<preset::Plan> load(const preset::Source& source, const preset::Overrides& changes = {},
                          const ReadFile& read_file = no_files);

/// Draws the whole plan through a back end: one of output::back_ends() or, with burin::cairo, of
/// output_cairo::back_ends(). Problems: a page the format cannot take, more points than `max_points`, bytes that could
/// not be written.
Result<Done> write(const preset::Plan& plan, const BackEnd& back_end, ByteSink& bytes,
                   const OutputOptions& options = {}, double max_points = default_max_points);

/// The same by format: "svg", "csv" or "dump".
Result<Done> write(const preset::Plan& plan, std::string_view format, ByteSink& bytes,
                   const OutputOptions& options = {}, double max_points = default_max_points);

/// The text of an SVG document: one layer a pen, in millimetres.
Result<std::string> to_svg(const preset::Plan& plan, const OutputOptions& options = {});

}  // namespace burin
