#include <string_view>

#include <gtest/gtest.h>

#include <burin/base/utf8.hpp>

namespace burin {
namespace {

TEST(Utf8, EveryCharacterComesBack) {
  for (char32_t code = 0; code <= 0x10FFFF; ++code) {
    if (code == 0xD800) code = 0xE000;
    const std::string text = utf8_text(code);
    const Utf8Character read = first_utf8_character(text + "x");
    ASSERT_EQ(read.code, code);
    ASSERT_EQ(read.length, text.size());
  }
  EXPECT_EQ(utf8_text(U'é'), "é");
  EXPECT_EQ(utf8_text(U'€'), "€");
  EXPECT_EQ(utf8_text(U'𝄞'), "𝄞");
}

TEST(Utf8, WhatIsNoneHasNoLength) {
  using namespace std::string_view_literals;
  for (const std::string_view text :
       {""sv, "\x80"sv, "\xBFz"sv,                                           // a following byte alone
        "\xC3"sv, "\xE2\x82"sv, "\xF0\x9D\x84"sv,                            // cut off
        "\xC3z"sv, "\xE2\x82z"sv, "\xE2z\x82"sv,                             // another character begins too early
        "\xC0\x80"sv, "\xC1\xBF"sv, "\xE0\x9F\xBF"sv, "\xF0\x8F\xBF\xBF"sv,  // not the shortest form
        "\xED\xA0\x80"sv, "\xED\xBF\xBF"sv,                                  // surrogates
        "\xF4\x90\x80\x80"sv, "\xF5\x80\x80\x80"sv, "\xFE"sv, "\xFF"sv}) {   // beyond U+10FFFF
    EXPECT_EQ(first_utf8_character(text).length, 0U) << testing::PrintToString(text);
  }
}

}  // namespace
}  // namespace burin
