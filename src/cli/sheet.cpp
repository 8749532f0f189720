#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <burin/base/number_text.hpp>
#include <cli/command.hpp>
#include <cli/contact_sheet.hpp>
#include <cli/draw_report.hpp>
#include <cli/draw_run.hpp>
#include <cli/file_io.hpp>
#include <cli/interrupt.hpp>
#include <cli/origin.hpp>
#include <cli/series_problems.hpp>
#include <cli/sheet_request.hpp>
#include <cli/tbb_executor.hpp>

namespace burin::cli {

namespace {

constexpr std::array examples{
    Example{"burin sheet winter-card --seed 0..24 -o sheet.pdf", "twenty-five seeds on one page"},
    Example{"burin sheet dragon --sweep levels=1..12 --page a3 -o dragons.svg", "a knob at twelve settings"},
    Example{"burin sheet winter-card --sweep motif=koch,levy,bud --seed 1..4 -o table.svg", "a row for each motif"},
};

/// Every result of the series, planned.
struct Planned {
  std::vector<SheetCell> cells;
  std::optional<ReadPiece> first;
  bool uses_seed = false;
};

Result<Planned> plan_cells(const PresetText& preset, const DrawRequest& request, const Series& series) {
  std::vector<std::optional<ReadyPiece>> pieces(series.count());
  std::vector<Problems> problems(series.count());
  TbbExecutor(request.threads).run(series.count(), [&](std::size_t i) {
    Result<ReadyPiece> piece = make_ready(preset, series.overrides(i, request.overrides), data_reader(preset.folder));
    if (piece) {
      pieces[i] = *std::move(piece);
    } else {
      problems[i] = piece.problems();
    }
  });
  if (Problems all = grouped_problems(problems, series); !all.empty()) return all;
  Planned planned;
  for (std::size_t i = 0; i < series.count(); ++i) {
    planned.uses_seed = planned.uses_seed || pieces[i]->plan.uses_seed();
    planned.cells.push_back({std::move(pieces[i]->plan), {}, series.label(i)});
    if (i == 0) planned.first = std::move(pieces[i]->read);
  }
  return planned;
}

/// 0.3333 for 0.3333333333333333; other texts as they are.
std::string short_value(const std::string& value) {
  constexpr std::size_t short_enough = 8;
  constexpr int decimals = 4;
  const std::optional<double> number = value.size() > short_enough ? parse_number(value) : std::nullopt;
  const std::string rounded = number && std::abs(*number) < 1e6 ? fixed_text(*number, decimals) : value;
  return rounded == "0" ? value : rounded;
}

/// "levels 1 .. 12   seed 0, 1, 2"
std::string series_words(const Series& series) {
  constexpr std::size_t most_listed = 4;
  std::string words;
  for (const Axis& axis : series.axes()) {
    std::string values;
    if (axis.values.size() > most_listed) {
      values = fmt::format("{} .. {}", short_value(axis.values.front()), short_value(axis.values.back()));
    } else {
      for (const std::string& value : axis.values) values += (values.empty() ? "" : ", ") + short_value(value);
    }
    words += fmt::format("{}{} {}", words.empty() ? "" : "   ", axis.name, values);
  }
  return words;
}

/// "levels 3, seed 7": what differs between the cells.
std::string caption_words(const Series& series, std::size_t index) {
  std::string words;
  const auto values = series.values(index);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (series.axes()[i].values.size() == 1) continue;
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", values[i].first, short_value(values[i].second));
  }
  return words;
}

/// Two axes make a table: the last one runs across.
std::optional<std::size_t> columns_of(const Series& series) {
  std::optional<std::size_t> across;
  std::size_t long_axes = 0;
  for (const Axis& axis : series.axes()) {
    if (axis.values.size() < 2) continue;
    across = axis.values.size();
    ++long_axes;
  }
  constexpr std::size_t most = 40;
  return long_axes == 2 && *across <= most ? across : std::nullopt;
}

/// What tells how the sheet was made, before the record of a piece: the words to say to burin sheet.
std::string record_of(const SheetRequest& request, const Series& series) {
  std::vector<std::string> words = request.words;
  for (const Sweep& sweep : request.draw.series.sweeps) words.push_back(sweep.written());
  for (const Axis& axis : series.axes()) {
    if (axis.name == "seed") words.push_back(fmt::format("--seed {}", fmt::join(axis.values, ",")));
  }
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + toml_string(word);
  return fmt::format("sheet = [{}]\n", list);
}

/// The sheet with the pieces' paper, for formats that show it, and without.
struct TwoSheets {
  ContactSheet plain;
  ContactSheet with_papers;
};

Result<TwoSheets> make_sheets(std::vector<SheetCell> cells, SheetStyle style) {
  Result<ContactSheet> plain = ContactSheet::make(cells, style);
  if (!plain) return plain.problems();
  style.papers = true;
  Result<ContactSheet> with_papers = ContactSheet::make(std::move(cells), style);
  if (!with_papers) return with_papers.problems();
  return TwoSheets{*std::move(plain), *std::move(with_papers)};
}

DrawOutcome draw_sheets(const TwoSheets& sheets, const DrawRequest& request, const PresetText& preset,
                        const ReadPiece& first, const std::string& record, const Surroundings& around) {
  const auto drawing_of = [&](const ContactSheet& sheet) {
    return Drawing{
        .stem = preset.stem + "-sheet",
        .sheet = sheet.sheet(),
        .check_size = [&](const auto& options, double max_points) { return sheet.check_size(options, max_points); },
        .run = [&](PathSink& sink, const auto& options) { return sheet.run(sink, options); },
        .origin =
            [&](const BackEnd& back_end) {
              Origin origin = make_origin(request, back_end, preset, first);
              origin.record = record + origin.record;
              return origin;
            }};
  };
  const Drawing plain = drawing_of(sheets.plain);
  const Drawing with_papers = drawing_of(sheets.with_papers);
  const auto drawing_for = [&](const BackEnd& back_end) -> const Drawing& {
    return back_end.format == "png" || request.paper ? with_papers : plain;
  };
  DrawOutcome outcome = draw_outputs(drawing_for, request, around);
  outcome.problems = with_source(std::move(outcome.problems), preset);
  return outcome;
}

std::string sheet_report(const ContactSheet& sheet, std::size_t count) {
  const Page& page = sheet.sheet().page;
  return fmt::format("  page  {} x {} mm\n  cells {} in {} columns and {} rows, drawn at {} %\n",
                     fixed_text(page.width_mm, 3), fixed_text(page.height_mm, 3), count, sheet.grid().columns,
                     sheet.grid().rows, fixed_text(100.0 * sheet.grid().scale, 1));
}

ExitCode run(const Arguments& arguments, const Console& console) {
  const Result<SheetRequest> request = read_sheet_request(arguments);
  if (!request) return console.fail_usage(request.problems(), "burin sheet");
  const DrawRequest& draw = request->draw;
  const Result<PresetText> preset = read_preset(draw.preset);
  if (!preset) return console.fail(preset.problems());
  const Result<Series> series = read_series(draw, *preset);
  if (!series) return console.fail(series.problems());

  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  Result<Planned> planned = plan_cells(*preset, draw, *series);
  if (!planned) return console.fail(planned.problems());
  SheetStyle style = request->style;
  if (!style.columns) style.columns = columns_of(*series);
  style.title = planned->first->about.title.empty() ? preset->stem : planned->first->about.title;
  style.subtitle = series_words(*series);
  style.captions = request->captions != CaptionKind::none && series->count() > 1;
  for (std::size_t i = 0; i < planned->cells.size(); ++i) {
    const bool number = request->captions == CaptionKind::numbers;
    planned->cells[i].caption = number ? std::to_string(i + 1) : caption_words(*series, i);
  }
  const Result<TwoSheets> sheets = make_sheets(std::move(planned->cells), style);
  if (!sheets) return console.fail(sheets.problems());
  if (!draw.quiet && !planned->uses_seed) console.note(seed_warning(draw));

  const bool live = console.shows_progress() && !draw.quiet;
  const DrawOutcome outcome = draw_sheets(*sheets, draw, *preset, *planned->first, record_of(*request, *series),
                                          {temporaries, interrupt.stop(), live});
  if (interrupt.signal() != 0) return interrupt.exit_code();
  if (outcome.code != ExitCode::done) return tell_problems(outcome, draw.command, console);
  if (draw.quiet) return ExitCode::done;
  const std::string report = outcome.report + sheet_report(sheets->plain, series->count());
  if (!draw.writes_stdout()) return console.print(report);
  console.note(report);
  return ExitCode::done;
}

}  // namespace

Command sheet_command() {
  return {
      "sheet",
      "draw many results of a preset on one page, to choose from",
      "PRESET [--seed SEEDS] [--sweep KNOB=VALUES]... [OPTIONS]",
      "A contact sheet: the pages of all results, scaled down with their pens, in the grid that shows them largest. "
      "With a sweep and seeds, or two sweeps, each value of the first has a row. Without -o the sheet goes to "
      "NAME-sheet.svg. The size of the pieces' own page is set with --set page.size=a5.\n\n"
      "Layers that are the same in all cells are one layer of the sheet. Paper is shown where draw shows it.\n\n"
      "Exit codes: 0 done, 2 wrong command line, 3 wrong preset or data, 4 too large, 5 cannot be written.",
      sheet_options(),
      examples,
      &run};
}

}  // namespace burin::cli
