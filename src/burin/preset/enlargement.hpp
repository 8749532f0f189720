#pragma once

#include <burin/geom/affine2.hpp>
#include <burin/path/sheet.hpp>
#include <burin/preset/piece.hpp>

namespace burin::preset {

/// A finished sheet scaled as a whole, as a print shop would: pens, dashes, margins and bleed grow with the drawing.
struct Enlargement {
  Page page;                ///< the new one
  double factor = 1.0;      ///< of every length
  Affine2 new_from_page{};  ///< from millimetres of the planned page
};

/// The largest page of the same shape that fits `onto` in either position. Where that leaves less than a hundredth of a
/// side, the new page is `onto` itself with the drawing in its middle: the sides of papers are rounded to millimetres.
Enlargement enlargement(const Page& page, PageSize onto);

/// The sheet with its page, pens and dashes enlarged.
Sheet enlarged(Sheet sheet, const Enlargement& enlargement);

}  // namespace burin::preset
