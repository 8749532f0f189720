#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <burin/path/sheet.hpp>
#include <burin/preset/load.hpp>

namespace burin::cli {

/// What a gallery tells of a piece.
struct GalleryEntry {
  std::string name;         ///< "koch": of the preset and the pictures
  std::string preset_path;  ///< from the gallery's folder, with slashes; empty: not told
  preset::Summary summary;
  std::uint64_t seed = 1;
  bool uses_seed = false;
  Page page;
  std::string dump_sha256;  ///< of the canonical dump
};

inline constexpr double thumbnail_px = 480.0;

/// The gallery's README.md: all thumbnails, then a section for each piece. The same entries give the same bytes.
std::string gallery_page(const std::vector<GalleryEntry>& entries);

/// The gallery's digests.txt: a line for each piece with the SHA-256 of its canonical dump, two blanks and its name.
std::string digests_text(const std::vector<GalleryEntry>& entries);

/// The names in such a text.
std::vector<std::string> names_in_digests(std::string_view text);

}  // namespace burin::cli
