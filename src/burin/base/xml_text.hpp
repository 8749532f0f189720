#pragma once

#include <string>
#include <string_view>

namespace burin {

/// `text` for a quoted attribute or between tags. What XML 1.0 cannot hold (most control characters, bytes that are no
/// UTF-8) becomes U+FFFD.
std::string xml_text(std::string_view text);

/// The same for text that must be read back byte for byte: before XML's own escapes, "\" is doubled and each byte that
/// XML cannot hold is written as "\x" and two hexadecimal digits.
std::string xml_exact_text(std::string_view text);

}  // namespace burin
