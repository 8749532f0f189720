#include <algorithm>
#include <string_view>

#include <cli/recover/found_record.hpp>

namespace burin::cli {

Result<std::string> find_record(const BytesAt& file, const std::string& shown) {
  constexpr std::size_t enough = 1024;  // a PDF's header may stand this far behind its beginning
  const std::string head = file.read(0, enough);
  const std::string_view text(head);
  const auto refuse = [&](std::string_view message) { return Problem{{shown}, std::string(message)}; };
  if (text.empty()) return refuse("is empty; an SVG, PDF or PNG that burin drew was expected");
  if (text.starts_with("\x89PNG\r\n\x1a\n")) return record_in_png(file, shown);
  if (text.starts_with("\x1f\x8b")) return refuse("is packed by gzip (an .svgz?); unpack it with gunzip first");
  if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE")) {
    return refuse("is UTF-16 text; if it is an SVG, save it as UTF-8");
  }
  const std::size_t first = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
  if (first != std::string_view::npos && text[first] == '<') return record_in_svg(file, shown);
  if (text.find("%PDF-") != std::string_view::npos) return record_in_pdf(file, shown);
  return refuse("is no SVG, PDF or PNG; burin redraws files of these formats that it drew");
}

}  // namespace burin::cli
