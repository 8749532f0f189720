#pragma once

#include <burin/path/back_end.hpp>

namespace burin::output_cairo {

/// PNG: the page on its paper, OutputOptions::dots_per_mm pixels to the millimetre, 8 bits a channel, grey when the
/// paper and every pen are. Carries pHYs, sRGB and the texts Title, Author, Description, Software and burin-origin
/// (the origin's record). Memory: 4 bytes a pixel, 8 while a layer with opacity is drawn.
BackEnd png_back_end();

}  // namespace burin::output_cairo
