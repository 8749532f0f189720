#pragma once

#include <string>

#include <burin/path/sheet.hpp>

namespace burin::output::pdf {

/// The dictionary of document information. Its keywords are the origin's record, character for character; its dates are
/// constants.
std::string info_dictionary(const Origin& origin);

/// The same for newer programs, as an XMP packet; without the record.
std::string xmp_packet(const Origin& origin);

/// 32 hexadecimal digits from what the file is made from: no clock and no chance.
std::string file_identifier(const Origin& origin);

}  // namespace burin::output::pdf
