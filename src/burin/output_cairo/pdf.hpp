#pragma once

#include <burin/path/back_end.hpp>

namespace burin::output_cairo {

/// PDF in true size. Title, author and summary are the document's own; its keywords are the origin's record, character
/// for character. Dates are constants. Pens of CMYK or spot colours are refused. Looks at OutputOptions::paper. Memory:
/// Cairo keeps the page until finish().
BackEnd pdf_back_end();

}  // namespace burin::output_cairo
