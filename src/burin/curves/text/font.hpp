#pragma once

#include <array>
#include <cstdint>

#include <burin/params/read_value.hpp>

namespace burin::curves::lettering {

/// The faces a text can be set in. Bold ones double their strokes; nothing is filled.
enum class Font : std::uint8_t { sans, sans_bold, serif, serif_bold, italic, italic_bold, script, script_bold, gothic };

constexpr auto words(Font) {
  return std::array<params::Word<Font>, 9>{{{"sans", Font::sans},
                                            {"sans-bold", Font::sans_bold},
                                            {"serif", Font::serif},
                                            {"serif-bold", Font::serif_bold},
                                            {"italic", Font::italic},
                                            {"italic-bold", Font::italic_bold},
                                            {"script", Font::script},
                                            {"script-bold", Font::script_bold},
                                            {"gothic", Font::gothic}}};
}

}  // namespace burin::curves::lettering
