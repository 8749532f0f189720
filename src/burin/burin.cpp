#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include <burin/burin.hpp>

namespace burin {

Result<std::string> no_files(std::string_view name) {
  return Problem{{std::string(name)}, "this program reads no data files; give burin::load a ReadFile"};
}

Result<preset::Plan> load(const preset::Source& source, const preset::Overrides& changes, const ReadFile& read_file) {
  Result<preset::Piece> piece = preset::load(source, changes, read_file);
  if (!piece) return piece.problems();
  const preset::About about = piece->about;
  Result<preset::Plan> plan = preset::Plan::make(*std::move(piece));
  if (plan) plan->set_origin({about.title, about.author, about.summary, source.text});
  return plan;
}

Result<Done> write(const preset::Plan& plan, const BackEnd& back_end, ByteSink& bytes, const OutputOptions& options,
                   double max_points) {
  if (Result<Done> accepted = back_end.accepts(plan.sheet(), options); !accepted) return accepted;
  preset::RunOptions run;
  run.space = back_end.space;
  run.tolerance_mm = back_end.tolerance_mm(plan.sheet(), options);
  const Result<Forecast> size = plan.check_size(run, max_points);
  if (!size) return size.problems();
  if (Result<Done> fits = check_memory(back_end, *size, plan.sheet(), options, default_max_memory_bytes); !fits)
    return fits;
  const std::unique_ptr<OutputSink> sink = back_end.open(bytes, plan.sheet(), options);
  // Only the sink itself can stop this run; finish() then says why.
  static_cast<void>(preset::run_for(
      *sink, [&](const preset::RunOptions& part) { return plan.run(*sink, part); }, run));
  return sink->finish();
}

Result<Done> write(const preset::Plan& plan, std::string_view format, ByteSink& bytes, const OutputOptions& options,
                   double max_points) {
  const std::span<const BackEnd> all = output::back_ends();
  const auto found = std::find_if(all.begin(), all.end(), [&](const BackEnd& b) { return b.format == format; });
  if (found == all.end()) {
    std::string known;
    for (const BackEnd& back_end : all) known += (known.empty() ? "" : ", ") + std::string(back_end.format);
    return Problem{{}, "the core writes no '" + std::string(format) + "'; it writes " + known};
  }
  return write(plan, *found, bytes, options, max_points);
}

Result<std::string> to_svg(const preset::Plan& plan, const OutputOptions& options) {
  StringSink bytes;
  if (const Result<Done> done = write(plan, "svg", bytes, options); !done) return done.problems();
  return bytes.take();
}

}  // namespace burin
