#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <burin/base/random.hpp>
#include <burin/base/xml_text.hpp>
#include <cli/recover/found_record.hpp>
#include <cli/recover/pdf_object.hpp>
#include <cli/recover/recovered.hpp>

#include "cli/made_files.hpp"

/// Records found in files of every make, and clear words about those in which none can be found.
namespace burin::cli {
namespace {

using namespace test;
using namespace std::string_literals;

std::string found(const std::string& file) {
  const Result<std::string> record = find_record(bytes_of(file), "x");
  return record ? *record : "PROBLEM " + problems_text(record.problems());
}

/// The same file through a disk that gives three bytes at a time to whoever reads on.
std::string found_bit_by_bit(const std::string& file) {
  const BytesAt slow{
      file.size(), [&](std::uint64_t offset, std::size_t count) {
        const bool streams = count > 100'000;
        return offset >= file.size() ? ""s : file.substr(static_cast<std::size_t>(offset), streams ? 3 : count);
      }};
  const Result<std::string> record = find_record(slow, "x");
  return record ? *record : "PROBLEM " + problems_text(record.problems());
}

bool refused(const std::string& file, const std::string& words) {
  const std::string answer = found(file);
  EXPECT_TRUE(answer.starts_with("PROBLEM x: error: ")) << answer;
  EXPECT_NE(answer.find(words), std::string::npos) << answer;
  return answer.starts_with("PROBLEM") && answer.find(words) != std::string::npos;
}

std::string svg_with(const std::string& inside, const std::string& more_spaces = {}) {
  return "<?xml version=\"1.0\"?>\n<!-- a > b -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:burin='urn:x-burin:origin'" +
         more_spaces + " title=\"a > b\">" + inside + "</svg>\n";
}

TEST(RecordInSvg, IsFoundWhateverAnEditorMadeOfTheFile) {
  const std::string path = "<g><path d=\"" + std::string(600'000, 'l') + "\"/></g>";
  const std::vector<std::pair<std::string, std::string>> cases{
      {svg_with("<metadata><burin:origin>a b</burin:origin></metadata>"), "a b"},
      {svg_with("<metadata><burin:origin xml:space=\"preserve\">\n a\n</burin:origin ></metadata>"), "\n a\n"},
      {svg_with("<ns0:origin>a</ns0:origin>", " xmlns:ns0=\"urn:x-burin:origin\""), "a"},
      {svg_with("<m><origin xmlns='urn:x-burin:origin'>a</origin></m>"), "a"},
      {svg_with("<origin>not this</origin><g xmlns:burin='urn:else'><burin:origin>nor this</burin:origin></g>"
                "<burin:origin>a</burin:origin>"),
       "a"},
      {svg_with("<g xmlns:burin='urn:else'/><burin:origin>a</burin:origin>"), "a"},
      {svg_with("<burin:origin>&lt;&gt;&amp;&quot;&apos;&#13;&#x41;&#xe9;&#x1F600;</burin:origin>"),
       "<>&\"'\rAé\U0001F600"},
      {svg_with("<burin:origin>a\r\nb\rc</burin:origin>"), "a\nb\nc"},
      {svg_with("<burin:origin>a<!-- <x> --><?p <y> ?><![CDATA[<b>&amp;]]>c</burin:origin>"), "a<b>&amp;c"},
      {svg_with("<burin:origin>\\\\n\\xff\\x0a</burin:origin>"), "\\n\xff\n"},
      {svg_with(path + "<burin:origin>at the end</burin:origin>"), "at the end"},
      {svg_with("<burin:origin>first</burin:origin><burin:origin>second</burin:origin>"), "first"},
      {"\xEF\xBB\xBF<!DOCTYPE svg PUBLIC \"a>b\" 'c' [<!ENTITY d \"]>\"> ]>" +
           svg_with("<burin:origin>a</burin:origin>").substr(22),
       "a"},
      {"<s:svg xmlns:s=\"http://www.w3.org/2000/svg\"><origin xmlns=\"urn:x-burin:origin\">a</origin></s:svg>", "a"},
  };
  for (const auto& [svg, record] : cases) {
    EXPECT_EQ(found(svg), record) << svg.substr(0, 300);
    EXPECT_EQ(found_bit_by_bit(svg), record) << svg.substr(0, 300);
  }
}

TEST(RecordInSvg, EveryTextThatIsWrittenComesBack) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    std::string text;
    for (std::uint64_t at = 0; at < 40; ++at) text += static_cast<char>(random_bits(seed, at) % 256);
    ASSERT_EQ(found(svg_with("<burin:origin>" + xml_exact_text(text) + "</burin:origin>")), text) << seed;
  }
}

TEST(RecordInSvg, SaysWhatIsWrong) {
  refused(svg_with("<path/>"), "dropped its metadata");
  refused(svg_with("<origin>a</origin>"), "dropped its metadata");
  refused("<html><body/></html>", "root is <html>");
  refused("<svg><g/></svg>", "no SVG");
  refused("<svg xmlns=\"http://www.w3.org/2000/svg\"><g>", "cut off");
  const std::string whole = svg_with("<burin:origin>a b</burin:origin>");
  refused(whole.substr(0, whole.find(" b<") + 2), "damaged");
  refused(svg_with("<burin:origin>&nbsp;</burin:origin>"), "damaged");
  refused(svg_with("<burin:origin>a<b/></burin:origin>"), "damaged");
  refused(svg_with("<burin:origin>\\q</burin:origin>"), "damaged");
  refused(svg_with("<burin:origin/>"), "damaged");
  refused(svg_with("<burin:origin>" + std::string(5 << 20, 'a') + "</burin:origin>"), "at most 4 MiB");
  refused("", "is empty");
  refused("GIF89a", "no SVG, PDF or PNG");
  refused("\x1f\x8b\x08", "gunzip");
  refused("\xFF\xFE<\0"s, "UTF-16");
  // Depth is a number and not a stack.
  std::string deep = "<svg xmlns=\"http://www.w3.org/2000/svg\">";
  for (int i = 0; i < 200'000; ++i) deep += "<g>";
  refused(deep, "cut off");
}

TEST(RecordInPng, IsReadFromEveryKindOfText) {
  const std::string key = "burin-origin\0"s;
  EXPECT_EQ(found(png_with(png_chunk("tEXt", key + "a\xe9"))), "aé");
  EXPECT_EQ(found(png_with(png_chunk("zTXt", key + '\0' + deflated("a\xe9")))), "aé");
  EXPECT_EQ(found(png_with(png_chunk("iTXt", key + "\0\0en\0translated\0aé"s))), "aé");
  EXPECT_EQ(found(png_with(png_chunk("iTXt", key + "\1\0\0\0"s + deflated("aé")))), "aé");
  EXPECT_EQ(found(png_with(png_chunk("zTXt", key + '\0' + deflated(std::string(200'000, 'a'))))),
            std::string(200'000, 'a'));
}

TEST(RecordInPng, SaysWhatIsWrong) {
  const std::string key = "burin-origin\0"s;
  refused(png_with(png_chunk("tEXt", "burin-originals\0a"s)), "dropped its texts");
  refused(png_with(png_chunk("zTXt", key + "\0no zlib"s)), "cannot be unpacked");
  refused(png_with(png_chunk("zTXt", key + "\1"s + deflated("a"))), "cannot be unpacked");
  refused(png_with(png_chunk("zTXt", key + '\0' + deflated(std::string(5 << 20, 'a')))), "cannot be unpacked");
  refused(png_with(png_chunk("iTXt", key + "\0\0no end"s)), "cannot be unpacked");
  refused(png_with(big_endian(0xF0000000U, 4) + "tEXt" + key), "claims 4026531840 bytes");
  refused(png_with(big_endian(0x70000000U, 4) + "tEXt" + key), "at most 4 MiB");
  std::string changed = png_with(png_chunk("tEXt", key + "abc"));
  changed[changed.find("abc")] = 'A';
  refused(changed, "checksum");
  const std::string whole = png_with(png_chunk("tEXt", key + "abc"));
  for (std::size_t size = png_signature.size(); size < whole.find("abc") + 7; ++size) {
    EXPECT_TRUE(refused(whole.substr(0, size), "cut off")) << size;
  }
}

TEST(RecordInPng, FilesOfAnySizeAreSteppedThrough) {
  // 400 chunks of 1 GB each, of which nothing is read.
  const std::string first = png_signature;
  const std::string chunk_head = big_endian(1 << 30, 4) + "IDAT";
  constexpr std::uint64_t chunk_bytes = (std::uint64_t{1} << 30U) + 12;
  const std::string last = png_chunk("tEXt", "burin-origin\0at last"s) + png_chunk("IEND", "");
  const std::uint64_t last_at = first.size() + 400 * chunk_bytes;
  std::uint64_t read_bytes = 0;
  const BytesAt huge{last_at + last.size(), [&](std::uint64_t offset, std::size_t count) {
                       read_bytes += count;
                       if (offset == 0) return first;
                       if (offset >= last_at) return last.substr(static_cast<std::size_t>(offset - last_at), count);
                       return chunk_head.substr((offset - first.size()) % chunk_bytes).substr(0, count);
                     }};
  const Result<std::string> record = find_record(huge, "x");
  ASSERT_TRUE(record) << problems_text(record.problems());
  EXPECT_EQ(*record, "at last");
  EXPECT_LT(read_bytes, 10'000U);
}

TEST(RecordInPdf, IsReadFromTablesAndStreams) {
  const std::string info = "<< /Title (t) /Keywords (a) >>";
  EXPECT_EQ(found(pdf_with_info(info)), "a");
  EXPECT_EQ(found(pdf_with_info(info, "some bytes before\n")), "a");
  EXPECT_EQ(found(pdf_with_info_in_streams(info)), "a");
  // An update at the end names a newer object.
  const std::string old = pdf_with_info(info);
  const std::string update = "1 0 obj << /Keywords (newer) >> endobj\n";
  const std::string updated =
      old + update +
      fmt::format("xref\n1 1\n{:010} 00000 n \ntrailer << /Size 2 /Prev {} >>\nstartxref\n{}\n%%EOF", old.size(),
                  old.rfind("xref\n0"), old.size() + update.size());
  EXPECT_EQ(found(updated), "newer");
  EXPECT_EQ(found(pdf_with_info("<< /Keywords (" + std::string(300'000, 'a') + ") >>")), std::string(300'000, 'a'));
}

TEST(RecordInPdf, StringsAreDecodedAsTheStandardSays) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"(a (b) \\(c\\\\)", "a (b) (c\\"},
      {"(\\n\\r\\t\\b\\f\\101\\53\\0053\\q)", "\n\r\t\b\fA+\0053q"},
      {"(a\\\nb\\\r\nc\r\nd\re)", "abc\nd\ne"},
      {"<61 62 6>", "ab`"},
      {"<FEFF00e9d83dde00>", "é\U0001F600"},
      {"<FFFEe900>", "é"},
      {"<EFBBBFc3a9>", "é"},
      {"(\xe9\xa0\x18\x8a)", "é€\u02D8\u2212"},
      {utf16_hexadecimal(u"a\nb"), "a\nb"},
  };
  for (const auto& [written, text] : cases) {
    EXPECT_EQ(found(pdf_with_info("<</Keywords " + written + ">>")), text) << written;
    EXPECT_EQ(found(pdf_with_info("<</Other [1 -.5 +4. /N#41 null true << >>]/Keywords%c\n" + written + ">>")), text);
  }
}

TEST(RecordInPdf, SaysWhatIsWrong) {
  refused("%PDF-1.5\n", "startxref");
  refused("%PDF-1.5\nstartxref\n5\n%%EOF", "no cross-reference table at byte 5");
  refused("%PDF-1.5\nstartxref\n99999999999999999999\n%%EOF", "startxref");
  refused(pdf_with_info("<< /Title (t) >>"), "no keywords");
  refused(pdf_with_info("(no table)"), "/Info");
  refused(pdf_with_info("<< /Keywords 5 >>"), "no text");
  refused(pdf_with_info("<< /Keywords <D800> >>"), "/Info");
  refused(pdf_with_info("<< /Keywords <FEFFD800> >>"), "no text");
  refused(pdf_with_info("<< /Keywords (\x7f) >>"), "no text");
  refused(pdf_with_info("<< /Keywords 1 0 R >>"), "no text");
  refused(pdf_with_info("1 0 R"), "/Info");
  refused(pdf_with_info(std::string(100'000, '[')), "/Info");
  std::string encrypted = pdf_with_info("<< /Keywords (a) >>");
  encrypted.replace(encrypted.find("/Size 2"), 7, "/Encrypt 1 0 R");
  refused(encrypted, "qpdf --decrypt");
  std::string without = pdf_with_info("<< /Keywords (a) >>");
  without.replace(without.find("/Info"), 5, "/None");
  refused(without, "no document information");
  // A table that names itself as the one before.
  std::string circle = pdf_with_info("<< >>");
  circle.replace(circle.find("/Size 2"), 7, fmt::format("/Prev {}", circle.find("xref\n0")));
  refused(circle, "no keywords");
}

TEST(RecordInPdf, AStreamWhoseLengthIsInsideOfItEndsTheSearch) {
  std::string pdf = pdf_with_info_in_streams("<< /Keywords (a) >>");
  const std::size_t length = pdf.find("/Length ");
  pdf.replace(length, pdf.find(" >>", length) - length, "/Length 1 0 R");
  EXPECT_TRUE(found(pdf).starts_with("PROBLEM"));
}

/// Files that burin could meet: changed at a few places, cut, or with a part of it twice.
std::string mutated(std::string file, std::uint64_t seed) {
  const auto draw = [&](std::uint64_t key, std::size_t below) {
    return static_cast<std::size_t>(random_bits(seed, key) % std::max<std::size_t>(below, 1));
  };
  const std::size_t changes = 1 + draw(1, 4);
  for (std::uint64_t change = 0; change < changes && !file.empty(); ++change) {
    const std::uint64_t key = 10 * change;
    const std::size_t at = draw(key + 2, file.size());
    const std::size_t count = draw(key + 3, 40);
    switch (draw(key + 4, 5)) {
      case 0:
        file[at] = static_cast<char>(draw(key + 5, 256));
        break;
      case 1:
        file.erase(at, count);
        break;
      case 2:
        file.insert(at, file.substr(draw(key + 6, file.size()), count));
        break;
      case 3:
        file[at] = "<>()[]/\\&;\0\xff"[draw(key + 7, 12)];
        break;
      default:
        file.resize(at);
    }
  }
  return file;
}

TEST(FindRecord, AnyFileGivesARecordOrAProblem) {
  const std::string key = "burin-origin\0"s;
  const std::vector<std::string> files{
      svg_with(
          "<metadata xmlns:a='b'><burin:origin>a&#13;\\xff<![CDATA[b]]></burin:origin></metadata><g><path d=''/></g>"),
      png_with(png_chunk("zTXt", key + '\0' + deflated("record"))),
      png_with(png_chunk("iTXt", key + "\1\0\0\0"s + deflated("record"))),
      pdf_with_info("<< /Keywords (a\\(b\\)\\101) /Other [1 2 0 R <41>] >>"),
      pdf_with_info("<< /Keywords <FEFF0041d83dde00> >>"),
      pdf_with_info_in_streams("<< /Keywords (a) >>"),
  };
  std::size_t records = 0;
  std::size_t problems = 0;
  for (const std::string& file : files) {
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
      const Result<std::string> record = find_record(bytes_of(mutated(file, seed)), "x");
      if (record) {
        ++records;
        static_cast<void>(read_record(*record, "x"));
      } else {
        ++problems;
        ASSERT_TRUE(problems_text(record.problems()).starts_with("x: error: "));
      }
    }
  }
  EXPECT_GT(records, 1000U);
  EXPECT_GT(problems, 1000U);
}

constexpr const char* least_record = "burin = \"0.0.1\"\npreset = \"a.toml\"\ntext = \"burin = 1\"\n";

TEST(ReadRecord, TellsTheOptionsInTheirOrder) {
  const Result<Recovered> record =
      read_record(std::string(least_record) +
                      "seed = \"7\"\nknobs = [\"a=1\", \"b=2\"]\nlandscape = true\npaper = false\n"
                      "[[data]]\nname = \"x.csv\"\nsha256 = \"00\"\n",
                  "f.svg");
  ASSERT_TRUE(record) << problems_text(record.problems());
  EXPECT_EQ(record->version, "0.0.1");
  EXPECT_EQ(record->preset.stem, "a");
  EXPECT_EQ(record->preset.source.text, "burin = 1");
  const std::vector<std::pair<std::string, std::string>> options{
      {"seed", "7"}, {"knob", "a=1"}, {"knob", "b=2"}, {"landscape", ""}};
  EXPECT_EQ(record->options, options);
  ASSERT_EQ(record->data.size(), 1U);
  EXPECT_EQ(record->data.front().name, "x.csv");
}

TEST(ReadRecord, SaysWhatIsWrong) {
  const auto problem = [](const std::string& text) {
    const Result<Recovered> record = read_record(text, "f.svg");
    return record ? std::string("no problem") : problems_text(record.problems());
  };
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "no text 'burin'"},
      {"burin = 1\npreset = \"a\"\ntext = \"\"", "no text 'burin'"},
      {"burin = ", "damaged"},
      {std::string(least_record) + "twist = \"3\"", "burin 0.0.1 drew it"},
      {std::string(least_record) + "seed = 3", "'seed' in its origin must be a text"},
      {std::string(least_record) + "paper = \"yes\"", "must be true or false"},
      {std::string(least_record) + "only = \"a\"", "must be a list of texts"},
      {std::string(least_record) + "only = [1]", "must be a list of texts"},
      {std::string(least_record) + "data = [1]", "without its name"},
      {std::string(5 << 20, ' '), "at most 4096 KiB"},
  };
  for (const auto& [text, words] : cases) {
    EXPECT_TRUE(problem(text).starts_with("f.svg: error: ")) << problem(text);
    EXPECT_NE(problem(text).find(words), std::string::npos) << problem(text);
  }
}

}  // namespace
}  // namespace burin::cli
