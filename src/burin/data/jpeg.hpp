#pragma once

#include <string>
#include <string_view>

#include <burin/base/result.hpp>
#include <burin/data/image.hpp>

namespace burin::data {

/// Reads a JPEG, grey or coloured, and turns it upright as its EXIF orientation says; opaque. Problems name `file`: no
/// JPEG, damaged, cut short, of colours that are not grey or RGB (CMYK), or more than max_image_pixels
/// (Trouble::limit).
Result<Image> read_jpeg(std::string_view bytes, const std::string& file);

}  // namespace burin::data
