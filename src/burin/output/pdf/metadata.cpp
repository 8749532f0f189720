#include <utility>

#include <fmt/format.h>

#include <burin/base/sha256.hpp>
#include <burin/base/xml_text.hpp>
#include <burin/output/pdf/metadata.hpp>
#include <burin/output/pdf/text.hpp>

namespace burin::output::pdf {

namespace {

constexpr std::string_view program = "burin";

std::string one_of_languages(std::string_view tag, std::string_view text) {
  if (text.empty()) return {};
  return fmt::format("<dc:{0}><rdf:Alt><rdf:li xml:lang=\"x-default\">{1}</rdf:li></rdf:Alt></dc:{0}>\n", tag,
                     xml_text(text));
}

}  // namespace

std::string info_dictionary(const Origin& origin) {
  constexpr std::string_view date = "(D:20000101000000Z)";
  std::string text = "<<";
  for (const auto& [key, value] : {std::pair<std::string_view, const std::string&>{"Title", origin.title},
                                   {"Author", origin.author},
                                   {"Subject", origin.summary},
                                   {"Keywords", origin.record}}) {
    if (!value.empty()) text += fmt::format("/{} {}\n", key, text_string(value));
  }
  return text + fmt::format("/Creator({0})/Producer({0})/CreationDate{1}/ModDate{1}/Trapped/False>>", program, date);
}

std::string xmp_packet(const Origin& origin) {
  constexpr std::string_view date = "2000-01-01T00:00:00Z";
  std::string xml =
      "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
      "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
      "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
      "<rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\""
      " xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\" xmlns:pdf=\"http://ns.adobe.com/pdf/1.3/\">\n"
      "<dc:format>application/pdf</dc:format>\n";
  xml += one_of_languages("title", origin.title);
  if (!origin.author.empty()) {
    xml += fmt::format("<dc:creator><rdf:Seq><rdf:li>{}</rdf:li></rdf:Seq></dc:creator>\n", xml_text(origin.author));
  }
  xml += one_of_languages("description", origin.summary);
  xml += fmt::format(
      "<xmp:CreatorTool>{0}</xmp:CreatorTool>\n<xmp:CreateDate>{1}</xmp:CreateDate>\n"
      "<xmp:ModifyDate>{1}</xmp:ModifyDate>\n<pdf:Producer>{0}</pdf:Producer>\n",
      program, date);
  return xml + "</rdf:Description>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>";
}

std::string file_identifier(const Origin& origin) {
  constexpr std::size_t digits = 32;
  Sha256 hash;
  for (const std::string* text : {&origin.title, &origin.author, &origin.summary, &origin.record}) {
    hash.add(*text);
    hash.add({"\0", 1});
  }
  return hash.hex_digest().substr(0, digits);
}

}  // namespace burin::output::pdf
