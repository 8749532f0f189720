#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/output/png_page.hpp>
#include <burin/output/png_rows.hpp>
#include <burin/output/png_stripes.hpp>
#include <burin/output/raster/colour_index.hpp>
#include <burin/output/raster/painter_team.hpp>
#include <burin/output/raster/png.hpp>

namespace burin::output {

namespace {

using raster::MaskTiles;
using raster::PainterTeam;
using raster::PixelBox;
using raster::Rgb;

constexpr double most_pixels_a_side = 100'000.0;

/// So many colours go into 4 bits.
constexpr std::size_t most_packed = 16;

/// Red, green and blue; what comes behind them.
std::uint8_t* pack(Rgb rgb, std::uint8_t* byte) {
  *byte++ = static_cast<std::uint8_t>(rgb >> 16U);
  *byte++ = static_cast<std::uint8_t>(rgb >> 8U);
  *byte++ = static_cast<std::uint8_t>(rgb);
  return byte;
}

/// One channel of grey pixels; what comes behind them.
std::uint8_t* pack_grey(std::span<const Rgb> pixels, std::uint8_t* byte) {
  const auto grey = [](Rgb rgb) { return static_cast<std::uint8_t>(rgb); };
  // Nearly all are the row of a whole tile, which the compiler packs at once when it knows how many there are.
  if (pixels.size() == MaskTiles::width) {
    return std::transform(pixels.data(), pixels.data() + MaskTiles::width, byte, grey);
  }
  return std::transform(pixels.begin(), pixels.end(), byte, grey);
}

class RasterPng final : public OutputSink {
 public:
  RasterPng(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options, const RasterPlan& plan);

  Flow begin(const PathHead& head) override { return ok_ ? painters_->begin(head) : Flow::stop; }
  Flow points(std::span<const Vec2> points) override { return painters_->points(points); }
  Vec2* room_for(std::size_t count) override { return painters_->room_for(count); }
  Flow contour() override { return painters_->contour(); }
  Flow end() override { return painters_->end(); }

  Box2 wanted_part_mm() const override;
  bool wants_another_run() override;
  Result<Done> finish() override;

 private:
  void begin_band(int top);
  bool write(std::string_view bytes) { return ok_ = ok_ && bytes_.write(bytes); }
  bool is_whole_page() const { return band_.height() == static_cast<int>(head_.height); }
  const Executor& executor() const;
  void choose_format();
  void read_row(int j, std::uint8_t* bytes);
  void write_page();
  void write_band();

  ByteSink& bytes_;
  const Sheet& sheet_;
  double dots_per_mm_;
  const raster::Kernel& kernel_;
  PngHead head_;
  int rows_per_band_;
  PixelBox band_;
  std::optional<PainterTeam> painters_;
  raster::Workers workers_;
  std::unique_ptr<PngStripes> stripes_;  ///< for several bands
  raster::ColourIndex index_;
  bool ok_ = true;
  bool had_memory_ = true;
};

RasterPng::RasterPng(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options, const RasterPlan& plan)
    : bytes_(bytes), sheet_(sheet), dots_per_mm_(options.dots_per_mm), kernel_(*plan.kernel), workers_(plan.workers) {
  const auto [width, height] = png_size(sheet.page, dots_per_mm_);
  head_.width = static_cast<std::uint32_t>(width);
  head_.height = static_cast<std::uint32_t>(height);
  head_.pixels = all_grey(sheet) ? PngPixels::grey : PngPixels::rgb;
  head_.chunks = png_chunks(sheet.made_by, dots_per_mm_);
  const double tiles = std::max(1.0, std::floor(plan.pixels_per_band / width / MaskTiles::height));
  rows_per_band_ = width * height <= plan.most_pixels_at_once
                       ? static_cast<int>(height)
                       : static_cast<int>(std::min(height, tiles * MaskTiles::height));
  begin_band(0);
}

void RasterPng::begin_band(int top) {
  band_ = {0, top, static_cast<int>(head_.width), std::min(top + rows_per_band_, static_cast<int>(head_.height))};
  painters_.reset();
  painters_.emplace(sheet_, dots_per_mm_, band_, kernel_, workers_);
}

Box2 RasterPng::wanted_part_mm() const {
  if (is_whole_page()) return Box2::everything();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{-infinity, band_.top / dots_per_mm_}, {infinity, band_.bottom / dots_per_mm_}};
}

bool RasterPng::wants_another_run() {
  if (!ok_ || band_.bottom == static_cast<int>(head_.height)) return false;
  painters_->finish();
  write_band();
  begin_band(band_.bottom);
  return ok_;
}

Result<Done> RasterPng::finish() {
  if (ok_) {
    painters_->finish();
    if (is_whole_page()) {
      write_page();
    } else {
      write_band();
      stripes_->finish();
    }
  }
  if (!ok_) return Problem{{}, "the PNG could not be written: " + bytes_.failure(), Trouble::output};
  if (!had_memory_) return Problem{{}, "there is not enough memory to draw the PNG", Trouble::limit};
  return Done{};
}

const Executor& RasterPng::executor() const {
  static const SerialExecutor serial;
  return workers_.count > 1 ? *workers_.executor : serial;
}

/// By the colours of the whole page.
void RasterPng::choose_format() {
  // More shades of grey than fit into 4 bits are as small without a palette.
  const std::size_t most = head_.pixels == PngPixels::grey ? most_packed : 256;
  const bool few_colours = index_.add(raster::rgb_of(sheet_.page.paper)).has_value() &&
                           painters_->visit_colours([&](std::span<const Rgb> pixels) {
                             return index_.add(pixels) && index_.colours().size() <= most;
                           });
  if (few_colours) {
    head_.pixels = PngPixels::palette;
    head_.palette = index_.colours();
  }
}

/// The bytes of a row in the format that is chosen.
void RasterPng::read_row(int j, std::uint8_t* bytes) {
  const Rgb paper = raster::rgb_of(sheet_.page.paper);
  if (head_.pixels == PngPixels::rgb) {
    painters_->visit_row(
        j,
        [&](std::size_t count) {
          for (std::size_t k = 0; k < count; ++k) bytes = pack(paper, bytes);
        },
        [&](std::span<const Rgb> pixels) {
          for (const Rgb rgb : pixels) bytes = pack(rgb, bytes);
        });
    return;
  }
  const bool is_grey = head_.pixels == PngPixels::grey;
  const std::uint8_t blank_byte = is_grey ? static_cast<std::uint8_t>(paper) : index_.add(paper).value_or(0);
  const auto blank = [&](std::size_t count) { bytes = std::fill_n(bytes, count, blank_byte); };
  if (is_grey) {
    painters_->visit_row(j, blank, [&](std::span<const Rgb> pixels) { bytes = pack_grey(pixels, bytes); });
  } else {
    painters_->visit_row(j, blank, [&](std::span<const Rgb> pixels) { bytes = index_.translate(pixels, bytes); });
  }
}

/// The whole page in one piece, in the format that suits the colours it has.
void RasterPng::write_page() {
  choose_format();
  if (head_.pixels == PngPixels::palette && head_.palette.size() <= most_packed) {
    PngRows rows(head_, [this](std::string_view some) { return write(some); });
    std::vector<std::uint8_t> row(head_.width);
    for (int j = 0; j < band_.bottom; ++j) {
      read_row(j, row.data());
      rows.add(row.data());
    }
    had_memory_ = rows.finish() || !ok_;
    return;
  }
  const std::optional<std::string> file = png_page(
      head_, [&](std::uint32_t j, std::uint8_t* row) { read_row(static_cast<int>(j), row); }, executor());
  had_memory_ = file.has_value();
  if (file) write(*file);
}

/// A band; the first fixes the format by what colours there can be.
void RasterPng::write_band() {
  if (stripes_ == nullptr) {
    if (head_.pixels == PngPixels::rgb && sheet_.layers.size() == 1) {
      const SheetLayer& layer = sheet_.layers.front();
      for (const Rgb shade :
           raster::shades(raster::rgb_of(sheet_.page.paper), sheet_.pens[layer.pen].colour, layer.opacity)) {
        index_.add(shade);
      }
      head_.pixels = PngPixels::palette;
      head_.palette = index_.colours();
    }
    stripes_ = std::make_unique<PngStripes>(head_, [this](std::string_view some) { return write(some); });
  }
  stripes_->add(
      static_cast<std::uint32_t>(band_.bottom),
      [&](std::uint32_t j, std::uint8_t* row) { read_row(static_cast<int>(j), row); }, executor());
}

Result<Done> accepts(const Sheet& sheet, const OutputOptions& options) {
  const auto [width, height] = png_size(sheet.page, options.dots_per_mm);
  if (std::max(width, height) <= most_pixels_a_side) return Done{};
  return Problem{{},
                 fmt::format("the PNG would have {} x {} pixels; {} a side is the most: give a lower --dpi, or --size "
                             "{}px or less",
                             fixed_text(width, 0), fixed_text(height, 0), most_pixels_a_side, most_pixels_a_side),
                 Trouble::limit};
}

/// With ink everywhere. Layers beyond the first need samples while there are colours of those below.
double memory_bytes(double, const Sheet& sheet, const OutputOptions& options) {
  const auto [width, height] = png_size(sheet.page, options.dots_per_mm);
  const RasterPlan plan;
  const double for_ink = sheet.layers.size() > 1 ? 12.0 : 8.0;
  constexpr double for_the_file = 6.0;
  if (width * height > plan.most_pixels_at_once) return 8e6 + for_ink * plan.pixels_per_band;
  return 8e6 + (for_ink + for_the_file) * width * height;
}

std::unique_ptr<OutputSink> open(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options) {
  return open_png(bytes, sheet, options, {});
}

}  // namespace

BackEnd png_back_end() {
  return {.name = "native",
          .format = "png",
          .summary = "PNG with soft edges on the paper's colour, the same bytes on every machine",
          .space = Space::page,
          .binary = true,
          .tolerance_mm = png_tolerance_mm,
          .accepts = accepts,
          .memory_bytes = memory_bytes,
          .open = open};
}

std::unique_ptr<OutputSink> open_png(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options,
                                     const RasterPlan& plan) {
  return std::make_unique<RasterPng>(bytes, sheet, options, plan);
}

}  // namespace burin::output
