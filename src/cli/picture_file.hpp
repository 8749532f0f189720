#pragma once

#include <string>

#include <burin/data/image.hpp>

namespace burin::cli {

/// Reads a PNG file; problems name its path.
Result<data::Image> read_picture(const std::string& path);

}  // namespace burin::cli
