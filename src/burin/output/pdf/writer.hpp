#pragma once

#include <memory>

#include <burin/path/back_end.hpp>

namespace burin::output {

/// Half a unit of the last decimal.
double pdf_tolerance_mm(const Sheet&, const OutputOptions& options);

/// Looks at `decimals` and at the page's size: more than viewers open is refused.
Result<Done> pdf_accepts(const Sheet& sheet, const OutputOptions& options);

/// A PDF in true size, written as the points come: one optional-content group a sheet layer, called as in SVG, style
/// once for each. Looks at `decimals` and `paper`. A page with bleed has TrimBox, BleedBox and crop marks around.
///
/// Strokes are painted in pieces of up to 1000 lines where a cut cannot show (round ends and corners, no dashes), else
/// whole; fills whole. A layer with opacity is a transparency group. A stroke of one point is a dot. Masks are not
/// drawn. A figure of 16 points or more that is placed without a change of shape is written once, as a form. Pens of
/// CMYK or spot colours keep them. Memory: constant, and in a layer with opacity the text of the longest path that is
/// not cut.
std::unique_ptr<OutputSink> open_pdf(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options);

}  // namespace burin::output
