#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <burin/params/fields.hpp>
#include <cli/contact_sheet.hpp>
#include <cli/draw_request.hpp>

namespace burin::cli {

/// What stands under each cell.
enum class CaptionKind : std::uint8_t { values, numbers, none };
constexpr auto words(CaptionKind) {
  return std::array<params::Word<CaptionKind>, 3>{
      {{"values", CaptionKind::values}, {"numbers", CaptionKind::numbers}, {"none", CaptionKind::none}}};
}

/// What `burin sheet` was asked for: what the pieces share with `burin draw`, and how the sheet looks.
struct SheetRequest {
  DrawRequest draw;
  SheetStyle style;
  CaptionKind captions = CaptionKind::values;
  std::vector<std::string> words;  ///< the sheet's own options as they were given
};

/// Those of `burin draw`, with page and margin for the sheet, and its own.
std::span<const OptionRow> sheet_options();

Result<SheetRequest> read_sheet_request(const Arguments& arguments);

}  // namespace burin::cli
