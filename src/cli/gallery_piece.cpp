#include <utility>

#include <burin/base/sha256.hpp>
#include <burin/burin.hpp>
#include <cli/draw_request.hpp>
#include <cli/draw_run.hpp>
#include <cli/file_io.hpp>
#include <cli/formats.hpp>
#include <cli/gallery_piece.hpp>
#include <cli/origin.hpp>

namespace burin::cli {

namespace {

/// The bytes that `burin draw` would write into one file of this format, asked for like this.
Result<std::string> drawn(const ReadyPiece& piece, const DrawRequest& request, std::string_view format) {
  const Result<const BackEnd*> back_end = choose_back_end(format, std::nullopt);
  if (!back_end) return back_end.problems();
  preset::Plan plan = piece.plan;
  plan.set_origin(make_origin(request, **back_end, piece.preset, piece.read));
  StringSink bytes;
  const Result<Done> done = write(plan, **back_end, bytes, output_options(request, plan.sheet().page));
  if (!done) return with_source(done.problems(), piece.preset);
  return bytes.take();
}

}  // namespace

Result<GalleryPiece> draw_for_gallery(const ShippedPreset& shipped, bool with_png) {
  const Result<PresetText> preset = read_preset(shipped.path);
  if (!preset) return preset.problems();
  const Result<ReadyPiece> piece = make_ready(*preset, {}, data_reader(preset->folder));
  if (!piece) return piece.problems();
  Result<preset::Summary> summary = preset::summarise(preset->source);
  if (!summary) return summary.problems();

  DrawRequest as_svg;
  as_svg.paper = true;
  as_svg.defs = true;
  DrawRequest as_png;
  as_png.longer_side_px = thumbnail_px;
  Result<std::string> svg = drawn(*piece, as_svg, "svg");
  if (!svg) return svg.problems();
  const Result<std::string> dump = drawn(*piece, {}, "dump");
  if (!dump) return dump.problems();
  const Result<const BackEnd*> png_writer = choose_back_end("png", std::nullopt);
  if (!png_writer) return png_writer.problems();

  GalleryPiece result;
  result.entry = {
      shipped.name,     {}, *std::move(summary), piece->read.seed, piece->plan.uses_seed(), piece->plan.sheet().page,
      sha256_hex(*dump)};
  result.svg = *std::move(svg);
  result.png_record = origin_record(as_png, **png_writer, piece->preset, piece->read);
  if (!with_png) return result;
  Result<std::string> png = drawn(*piece, as_png, "png");
  if (!png) return png.problems();
  result.png = *std::move(png);
  return result;
}

}  // namespace burin::cli
