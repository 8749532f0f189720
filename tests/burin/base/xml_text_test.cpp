#include <gtest/gtest.h>

#include <burin/base/xml_text.hpp>

#include "support/svg_reader.hpp"

namespace burin {
namespace {

TEST(XmlText, EscapesWhatMarksUp) {
  EXPECT_EQ(xml_text("a < b && c > \"d\" 'e'"), "a &lt; b &amp;&amp; c &gt; &quot;d&quot; 'e'");
  EXPECT_EQ(xml_text("tab\tline\nreturn\r"), "tab&#9;line&#10;return&#13;");
  EXPECT_EQ(xml_text(""), "");
}

TEST(XmlText, ReplacesWhatXmlCannotHold) {
  EXPECT_EQ(xml_text(std::string_view("a\0b", 3)), "a\uFFFDb");
  EXPECT_EQ(xml_text("\x1F\x7F"), "\uFFFD\x7F");
  EXPECT_EQ(xml_text("\xEF\xBF\xBF"), "\uFFFD\uFFFD\uFFFD");  // U+FFFF
  EXPECT_EQ(xml_text("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
  EXPECT_EQ(xml_text("\xC1\x81"), "\uFFFD\uFFFD");            // an overlong A
  EXPECT_EQ(xml_text("\xE0\x80\xAF"), "\uFFFD\uFFFD\uFFFD");  // an overlong slash
  EXPECT_EQ(xml_text("\u00E9\u20AC\U0001F3A8"), "\u00E9\u20AC\U0001F3A8");
  EXPECT_EQ(xml_text("\xF0\x9F\x8E"), "\uFFFD\uFFFD\uFFFD");  // cut short
}

TEST(XmlExactText, KeepsLinesAndEscapesTheRest) {
  EXPECT_EQ(xml_exact_text("a\n\tb"), "a\n\tb");
  EXPECT_EQ(xml_exact_text("C:\\x \x01\xFF"), "C:\\\\x \\x01\\xff");
}

TEST(XmlExactText, EveryPairOfBytesReadsBack) {
  for (int first = 0; first < 256; ++first) {
    std::string pairs;
    for (int second = 0; second < 256; ++second) {
      pairs += static_cast<char>(first);
      pairs += static_cast<char>(second);
    }
    const std::string document = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<a>" + xml_exact_text(pairs) + "</a>";
    EXPECT_EQ(test::exact_text(test::read_xml(document).text), pairs) << first;
  }
}

}  // namespace
}  // namespace burin
