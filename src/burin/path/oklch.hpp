#pragma once

#include <burin/path/colour.hpp>

namespace burin {

/// The colour `share` of the way from one to another through OKLCH, where equal steps look equal: lightness and chroma
/// change evenly, the hue the short way around (not at all beside a grey, which has none). What sRGB cannot show is cut
/// off channel by channel. Shares 0 and 1 give the colours themselves. Source: B. Ottosson, "A perceptual color space
/// for image processing", 2020; CSS Color Module Level 4, section 12.
Colour mix_colours(Colour from, Colour to, double share);

}  // namespace burin
