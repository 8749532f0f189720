#pragma once

#include <string>

#include <burin/base/result.hpp>
#include <cli/gallery_page.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

/// A piece as a gallery shows it.
struct GalleryPiece {
  GalleryEntry entry;
  std::string svg;         ///< what `burin draw NAME --paper -o NAME.svg` writes
  std::string png;         ///< what `burin draw NAME -o NAME.png --size 480px` writes; empty: not asked for
  std::string png_record;  ///< the origin that stands in it
};

/// Reads and draws a preset. `with_png`: the thumbnail too.
Result<GalleryPiece> draw_for_gallery(const ShippedPreset& shipped, bool with_png);

}  // namespace burin::cli
