#pragma once

#include <optional>
#include <string>
#include <vector>

#include <burin/data/image.hpp>

/// Pictures that show how two pictures differ.
namespace burin::cli {

/// Both pictures in pale grey, and on it what differs: red where the second is darker or as dark, blue where it is
/// lighter, the stronger the larger the difference. A yellow fringe makes single pixels easy to find. Pre: one size.
data::Image difference_picture(const data::Image& first, const data::Image& second);

/// Pictures beside each other on a grey ground, in their order; a grey field for one that is missing. Pre: at least one
/// picture.
data::Image side_by_side(const std::vector<std::optional<data::Image>>& pictures);

/// A PNG of 8-bit colours; what is transparent shows white. Nothing: there is no memory for it.
std::optional<std::string> png_of(const data::Image& picture);

}  // namespace burin::cli
