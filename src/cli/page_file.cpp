#include <memory>

#include <fmt/format.h>

#include <cli/atomic_file.hpp>
#include <cli/formats.hpp>
#include <cli/interrupt.hpp>
#include <cli/page_file.hpp>
#include <cli/temporaries.hpp>

namespace burin::cli {

namespace {

Result<const BackEnd*> page_back_end(const std::string& path, const std::string& who) {
  const Result<std::string> format = path == "-" ? Result<std::string>("svg") : format_of_suffix(path);
  if (!format) return format.problems();
  const Result<const BackEnd*> back_end = choose_back_end(*format, std::nullopt);
  if (back_end && (*back_end)->space != Space::page) {
    return Problem{{who}, fmt::format("{} holds a curve's own points; draw a page as svg, pdf or png", *format)};
  }
  return back_end;
}

Result<Done> write(const PageDrawing& page, const BackEnd& back_end, AtomicFile& file) {
  const std::unique_ptr<OutputSink> sink = back_end.open(file, page.sheet, {});
  // A sink that cannot write ends the drawing too; finish() or commit() tells why.
  while (page.draw(*sink) == Flow::go && sink->wants_another_run()) continue;
  if (const Result<Done> finished = sink->finish(); !finished && !file.failed()) return finished.problems();
  return file.commit();
}

}  // namespace

ExitCode write_page(const PageDrawing& page, const std::string& path, const std::string& who, const Console& console) {
  const Result<const BackEnd*> back_end = page_back_end(path, who);
  if (!back_end) return console.fail_usage(back_end.problems(), who);
  Temporaries temporaries;
  const Interrupt interrupt([&temporaries] { temporaries.remove_all(); });
  const Result<std::unique_ptr<AtomicFile>> file = AtomicFile::open(path, temporaries, interrupt.stop());
  if (!file) return console.fail(file.problems());
  if ((*back_end)->binary && (*file)->is_terminal()) {
    return console.fail_usage({Problem{{who}, "write a file (-o NAME.png) or a pipe, not a terminal"}}, who);
  }
  const Result<Done> written = write(page, **back_end, **file);
  if (interrupt.signal() != 0) return interrupt.exit_code();
  if (!written) return console.fail(written.problems());
  return ExitCode::done;
}

}  // namespace burin::cli
