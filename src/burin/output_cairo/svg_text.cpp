#include <algorithm>

#include <fmt/format.h>

#include <burin/base/xml_text.hpp>
#include <burin/output_cairo/svg_text.hpp>

namespace burin::output_cairo {

namespace {

constexpr std::string_view surface_id = "surface";

std::size_t digit_count(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
}

}  // namespace

bool SvgText::write(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
      line_ += text;
      return !to_.failed();
    }
    line_ += text.substr(0, end + 1);
    if (!write_line(line_)) return false;
    line_.clear();
    text.remove_prefix(end + 1);
  }
  return !to_.failed();
}

bool SvgText::finish() {
  const bool written = write_line(line_);
  line_.clear();
  return written;
}

bool SvgText::write_line(std::string_view line) {
  const bool ends_head = in_head_ && line.starts_with("<svg");
  for (std::size_t at = line.find(surface_id); at != std::string_view::npos; at = line.find(surface_id)) {
    const std::size_t id_begin = at + surface_id.size();
    const std::size_t id_size = digit_count(line.substr(id_begin));
    to_.write(line.substr(0, id_begin));
    if (id_size > 0) {
      const auto id = new_ids_.try_emplace(std::string(line.substr(id_begin, id_size)), new_ids_.size() + 1).first;
      to_.write(fmt::format("{}", id->second));
    }
    line.remove_prefix(id_begin + id_size);
  }
  if (!to_.write(line)) return false;
  if (!ends_head) return true;
  in_head_ = false;
  return write_origin();
}

bool SvgText::write_origin() {
  std::string xml;
  if (!origin_.title.empty()) xml += fmt::format("<title>{}</title>\n", xml_text(origin_.title));
  if (!origin_.summary.empty()) xml += fmt::format("<desc>{}</desc>\n", xml_text(origin_.summary));
  xml += "<metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\" xmlns:burin=\"urn:x-burin:origin\">\n";
  if (!origin_.author.empty()) xml += fmt::format("<dc:creator>{}</dc:creator>\n", xml_text(origin_.author));
  if (!origin_.record.empty()) {
    xml += fmt::format("<burin:origin xml:space=\"preserve\">{}</burin:origin>\n", xml_exact_text(origin_.record));
  }
  xml += "</metadata>\n";
  return to_.write(xml);
}

}  // namespace burin::output_cairo
