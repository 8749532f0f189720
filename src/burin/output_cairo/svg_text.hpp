#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include <burin/output_cairo/byte_stream.hpp>
#include <burin/path/sheet.hpp>

namespace burin::output_cairo {

/// Makes Cairo's SVG text presentable on its way to a stream. Cairo numbers its surfaces over the whole process
/// (`<g id="surface5">`): here they count from 1 in every file. And it cannot carry an origin: title, desc and metadata
/// are put behind the svg element's tag. Works line by line; memory: the longest line.
class SvgText {
 public:
  SvgText(ByteStream& to, const Origin& origin) : to_(to), origin_(origin) {}

  /// Takes the text in pieces of any size.
  bool write(std::string_view text);
  /// Passes an unended last line on.
  bool finish();

 private:
  bool write_line(std::string_view line);
  bool write_origin();

  ByteStream& to_;
  const Origin& origin_;
  std::string line_;
  bool in_head_ = true;
  std::map<std::string, std::size_t, std::less<>> new_ids_;
};

}  // namespace burin::output_cairo
