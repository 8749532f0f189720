#pragma once

#include <memory>

#include <burin/path/back_end.hpp>

namespace burin::output {

/// The canonical dump: what a drawing is, as text to compare. Page, pens and layers first, then every path with its
/// points in whole micrometres of the page, a line a point; neither origin nor version. Nothing is left out: masks and
/// points that round onto their predecessor are shown, so its tolerance is 0.
///
/// When the paths take more than dump_limit_bytes they are replaced by counts and bounds of each layer and the SHA-256
/// of their text. The text is written by finish(). Looks at no option. Memory: dump_limit_bytes.
std::unique_ptr<OutputSink> open_dump(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options);

constexpr std::size_t dump_limit_bytes = 1'000'000;

}  // namespace burin::output
