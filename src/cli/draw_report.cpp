#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <cli/draw_report.hpp>

namespace burin::cli {

namespace {

std::string mm_text(double mm) {
  return fixed_text(mm, 3);
}

}  // namespace

std::string output_report(const OutputJob& job, const OutputCounts& counts) {
  std::string text =
      fmt::format("{}: {} points drawn of {} asked", job.path == "-" ? "stdout" : job.path,
                  count_text(static_cast<double>(counts.drawn_points)), count_text(job.forecast.asked_points));
  if (counts.skipped_points > 0)
    text += fmt::format(", {} skipped", count_text(static_cast<double>(counts.skipped_points)));
  return text + fmt::format("; {} bytes\n", count_text(static_cast<double>(counts.bytes)));
}

std::string piece_report(const preset::Plan& plan, const ReadPiece& piece, bool verbose) {
  const Sheet& sheet = plan.sheet();
  std::string text = fmt::format("  page  {} x {} mm\n", mm_text(sheet.page.width_mm), mm_text(sheet.page.height_mm));
  if (sheet.page.bleed_mm > 0.0) text += fmt::format("  bleed {} mm\n", mm_text(sheet.page.bleed_mm));
  std::size_t number = 1;
  for (const Pen& pen : sheet.pens) {
    text += fmt::format("  pen   {} {} {} {} mm\n", number++, pen.name, colour_text(pen.colour), mm_text(pen.width_mm));
  }
  text += fmt::format("  seed  {}{}\n", piece.seed, plan.uses_seed() ? "" : " (nothing here is random)");
  if (!verbose) return text;
  for (const SheetLayer& layer : sheet.layers) {
    text += fmt::format("  layer {} with pen {}\n", layer.name, layer.pen + 1);
  }
  for (const params::DataDigest& data : piece.data)
    text += fmt::format("  data  {} sha256 {}\n", data.name, data.sha256);
  return text;
}

ExitCode tell_problems(const DrawOutcome& outcome, std::string_view command, const Console& console) {
  if (outcome.problems.empty()) return outcome.code;
  if (outcome.code == ExitCode::usage) return console.fail_usage(outcome.problems, command);
  return console.fail(outcome.problems);
}

}  // namespace burin::cli
