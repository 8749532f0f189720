#include <optional>
#include <string_view>

#include <cli/recover/found_record.hpp>
#include <cli/recover/pdf_document.hpp>

namespace burin::cli {

Result<std::string> record_in_pdf(const BytesAt& pdf, const std::string& shown) {
  const auto refuse = [&](std::string_view message) { return Problem{{shown}, std::string(message)}; };
  const Result<PdfDocument> document = PdfDocument::open(pdf, shown);
  if (!document) return document.problems();
  if (document->trailer_entry("Encrypt") != nullptr) {
    return refuse("is encrypted; 'qpdf --decrypt FILE PLAIN.pdf' makes a file that can be read");
  }
  const PdfObject* reference = document->trailer_entry("Info");
  if (reference == nullptr) {
    return refuse(
        "has no document information, where burin keeps what it drew: it was not drawn by burin, or a "
        "program that saved it again dropped it");
  }
  const std::optional<PdfObject> info = document->resolved(*reference);
  const PdfDictionary* table = info ? info->as<PdfDictionary>() : nullptr;
  if (table == nullptr) return refuse("is damaged: the PDF's document information (/Info) cannot be read");
  const PdfObject* entry = table->find("Keywords");
  if (entry == nullptr) {
    return refuse(
        "has no keywords, where burin keeps what it drew: it was not drawn by burin, or a program that saved "
        "it again dropped them");
  }
  const std::optional<PdfObject> keywords = document->resolved(*entry);
  const std::string* bytes = keywords ? keywords->as<std::string>() : nullptr;
  const std::optional<std::string> text = bytes == nullptr ? std::nullopt : utf8_of_pdf_text(*bytes);
  if (!text || text->size() > longest_record_bytes) {
    return refuse("is damaged: its keywords (/Keywords of /Info) are no text that burin could have written");
  }
  return *text;
}

}  // namespace burin::cli
