#pragma once

#include <string>

#include <burin/path/sheet.hpp>

namespace burin::output::pdf {

/// How far the sheet of paper reaches beyond the trimmed page on every side: 0 without bleed, else the bleed, the crop
/// marks and a little air.
double page_surround_mm(const Page& page);

/// The entries of a page's dictionary that say its size in points: MediaBox and, with bleed, where it is trimmed.
std::string page_boxes(const Page& page);

/// The operators before the first layer: from here on millimetres of the page, y down. With bleed also crop marks,
/// which paint in colour space /Marks, and a clip to the bleed. `paper`: the page's colour below everything.
std::string page_begin(const Page& page, bool paper);

/// Where ink can show, for example "-3 -3 213 300": left, top, right, bottom in units of `unit_mm`.
std::string ink_box(const Page& page, double unit_mm);

/// The colour space of crop marks: all inks of the printer.
std::string crop_mark_space();

}  // namespace burin::output::pdf
