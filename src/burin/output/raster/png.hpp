#pragma once

#include <memory>

#include <burin/output/raster/kernel.hpp>
#include <burin/output/raster/painter_team.hpp>
#include <burin/path/back_end.hpp>

namespace burin::output {

/// PNG by the rasterizer of this room: the same bytes on every machine. Looks at `dots_per_mm`. 8-bit grey when the
/// paper and every pen are, a palette when the page has few colours, else RGB; with the chunks of png_chunks().
///
/// A page of up to 16 million pixels is drawn at once: memory is about 1.5 kB for each tile of 16 x 8 pixels with ink
/// and twice the file while it is put together. Larger ones are drawn in bands of 3 million pixels, each in a run of
/// its own, and never need more than 64 MB, whatever their size. Either way, each worker beyond the first needs up to 5
/// MB.
BackEnd png_back_end();

/// How a page is drawn. The bytes are the same for every kernel and any number of workers, the pixels for all bands.
struct RasterPlan {
  double most_pixels_at_once = 16e6;
  double pixels_per_band = 3e6;
  const raster::Kernel* kernel = &raster::best_kernel();
  raster::Workers workers{};
};

std::unique_ptr<OutputSink> open_png(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options,
                                     const RasterPlan& plan);

}  // namespace burin::output
