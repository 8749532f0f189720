#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <cli/recover/found_record.hpp>
#include <cli/recover/inflate.hpp>
#include <cli/recover/pdf_document.hpp>

namespace burin::cli {

namespace {

constexpr std::size_t header_bytes = 1024;
constexpr std::size_t tail_bytes = 2048;
constexpr std::size_t first_window_bytes = std::size_t{16} << 10U;
/// UTF-16 in hexadecimal digits makes four bytes of one.
constexpr std::size_t largest_window_bytes = 8 * longest_record_bytes;
constexpr std::size_t largest_stream_bytes = std::size_t{64} << 20U;
constexpr std::size_t most_sections = 10'000;
constexpr std::size_t table_entry_bytes = 20;
constexpr std::size_t most_table_bytes = std::size_t{128} << 20U;

std::optional<std::uint64_t> count_in(const PdfDictionary& dictionary, std::string_view key) {
  const PdfObject* value = dictionary.find(key);
  return value == nullptr ? std::nullopt : value->as_count();
}

bool is_name(const PdfObject* object, std::string_view name) {
  const PdfName* found = object == nullptr ? nullptr : object->as<PdfName>();
  return found != nullptr && found->name == name;
}

/// The only member of a list of one, which stands for itself.
const PdfObject* single(const PdfObject* object) {
  const PdfArray* list = object == nullptr ? nullptr : object->as<PdfArray>();
  if (list == nullptr) return object;
  return list->size() == 1 ? &list->front() : nullptr;
}

unsigned char paeth(unsigned char left, unsigned char up, unsigned char up_left) {
  const int estimate = left + up - up_left;
  const int to_left = std::abs(estimate - left);
  const int to_up = std::abs(estimate - up);
  const int to_up_left = std::abs(estimate - up_left);
  if (to_left <= to_up && to_left <= to_up_left) return left;
  return to_up <= to_up_left ? up : up_left;
}

/// Rows of `columns` bytes, each behind a byte that names its PNG filter, made plain; nothing when a row is cut or the
/// filter unknown.
std::optional<std::string> without_png_filters(std::string_view rows, std::size_t columns) {
  if (columns == 0 || rows.size() % (columns + 1) != 0) return std::nullopt;
  std::string plain;
  std::string before(columns, '\0');
  for (; !rows.empty(); rows.remove_prefix(columns + 1)) {
    const char filter = rows.front();
    std::string row(rows.substr(1, columns));
    for (std::size_t i = 0; i < columns; ++i) {
      const auto left = static_cast<unsigned char>(i == 0 ? '\0' : row[i - 1]);
      const auto up = static_cast<unsigned char>(before[i]);
      const auto up_left = static_cast<unsigned char>(i == 0 ? '\0' : before[i - 1]);
      const std::array<int, 5> guesses{0, left, up, (left + up) / 2, paeth(left, up, up_left)};
      if (filter < 0 || filter > 4) return std::nullopt;
      row[i] = static_cast<char>(static_cast<unsigned char>(row[i]) + guesses.at(static_cast<std::size_t>(filter)));
    }
    plain += row;
    before = std::move(row);
  }
  return plain;
}

/// A stream's data unpacked as its dictionary says; nothing for filters other than Flate with PNG's predictors.
std::optional<std::string> unpacked(std::string data, const PdfDictionary& stream) {
  const PdfObject* filter = stream.find("Filter");
  if (filter == nullptr) return data;
  if (!is_name(single(filter), "FlateDecode")) return std::nullopt;
  std::optional<std::string> plain = inflated(data, largest_stream_bytes);
  const PdfObject* parameters = single(stream.find("DecodeParms"));
  const PdfDictionary* table = parameters == nullptr ? nullptr : parameters->as<PdfDictionary>();
  const std::uint64_t predictor = table == nullptr ? 1 : count_in(*table, "Predictor").value_or(1);
  if (!plain || predictor == 1) return plain;
  if (predictor < 10) return std::nullopt;
  const std::uint64_t columns = count_in(*table, "Columns").value_or(1);
  return columns > plain->size() ? std::nullopt : without_png_filters(*plain, static_cast<std::size_t>(columns));
}

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char c : bytes) value = value << 8U | static_cast<unsigned char>(c);
  return value;
}

}  // namespace

Result<PdfDocument> PdfDocument::open(const BytesAt& pdf, const std::string& shown) {
  PdfDocument document(pdf);
  const std::size_t header = pdf.read(0, header_bytes).find("%PDF-");
  if (header == std::string::npos) return Problem{{shown}, "is no PDF: it does not begin with %PDF-"};
  document.begin_ = header;
  std::optional<std::uint64_t> next = document.last_table();
  if (!next) return Problem{{shown}, "is cut off: the PDF's last lines, with 'startxref', are missing"};
  std::set<std::uint64_t> seen;
  while (next && seen.insert(*next).second) {
    PdfDictionary trailer;
    if (document.sections_.size() > most_sections ||
        !(document.read_table(*next, trailer) || document.read_table_stream(*next, trailer))) {
      return Problem{
          {shown},
          fmt::format("is damaged: the PDF has no cross-reference table at byte {}; 'qpdf FILE REPAIRED.pdf' "
                      "may repair it",
                      *next)};
    }
    // A table may name a stream with what old readers need not see.
    const std::optional<std::uint64_t> hidden = count_in(trailer, "XRefStm");
    PdfDictionary ignored;
    if (hidden) document.read_table_stream(*hidden, ignored);
    next = count_in(trailer, "Prev");
    document.trailers_.push_back(std::move(trailer));
  }
  return document;
}

const PdfObject* PdfDocument::trailer_entry(std::string_view key) const {
  for (const PdfDictionary& trailer : trailers_) {
    if (const PdfObject* value = trailer.find(key)) return value;
  }
  return nullptr;
}

std::optional<std::uint64_t> PdfDocument::last_table() const {
  constexpr std::string_view word = "startxref";
  const std::uint64_t from = pdf_->size - std::min<std::uint64_t>(pdf_->size, tail_bytes);
  const std::string tail = pdf_->read(from, tail_bytes);
  const std::size_t at = tail.rfind(word);
  return at == std::string::npos ? std::nullopt : PdfLexer(tail, at + word.size()).take_count();
}

/// xref, then "first count" and `count` entries of 20 bytes, again and again, then "trailer << ... >>".
bool PdfDocument::read_table(std::uint64_t at, PdfDictionary& trailer) {
  bool is_first = true;
  for (std::uint64_t here = begin_ + at; sections_.size() <= most_sections; is_first = false) {
    const std::string window = pdf_->read(here, 256);
    PdfLexer lexer(window);
    if (is_first && !lexer.take_word("xref")) return false;
    if (lexer.take_word("trailer")) {
      const std::optional<Placed> placed = object_at(here + lexer.at());
      const PdfDictionary* found = placed ? placed->object.as<PdfDictionary>() : nullptr;
      if (found != nullptr) trailer = *found;
      return found != nullptr;
    }
    const std::optional<std::uint64_t> first = lexer.take_count();
    const std::optional<std::uint64_t> count = lexer.take_count();
    if (!first || !count) return false;
    lexer.skip_blanks();
    const std::uint64_t entries_at = here + lexer.at();
    if (*count > (pdf_->size - entries_at) / table_entry_bytes) return false;
    sections_.push_back({*first, *count, entries_at});
    here = entries_at + *count * table_entry_bytes;
  }
  return false;
}

bool PdfDocument::read_table_stream(std::uint64_t at, PdfDictionary& trailer) {
  const std::optional<Placed> placed = numbered_object_at(at, std::nullopt);
  const PdfDictionary* dictionary = placed ? placed->object.as<PdfDictionary>() : nullptr;
  if (dictionary == nullptr || !is_name(dictionary->find("Type"), "XRef")) return false;
  const std::optional<std::string> bytes = stream_bytes(*placed, longest_chain);
  const PdfObject* width_list = dictionary->find("W");
  const PdfArray* widths = width_list == nullptr ? nullptr : width_list->as<PdfArray>();
  const std::optional<std::uint64_t> size = count_in(*dictionary, "Size");
  if (!bytes || widths == nullptr || widths->size() != 3 || !size) return false;
  Section model;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<std::uint64_t> width = (*widths)[i].as_count();
    if (!width || *width > 8) return false;
    model.widths.at(i) = static_cast<std::size_t>(*width);
  }
  const std::size_t entry_bytes = model.widths[0] + model.widths[1] + model.widths[2];
  PdfArray runs{PdfObject{0.0}, PdfObject{static_cast<double>(*size)}};
  if (const PdfObject* index = dictionary->find("Index"); index != nullptr && index->as<PdfArray>() != nullptr) {
    runs = *index->as<PdfArray>();
  }
  std::string_view rest(*bytes);
  for (std::size_t run = 0; run + 1 < runs.size() && sections_.size() <= most_sections; run += 2) {
    const std::optional<std::uint64_t> first = runs[run].as_count();
    const std::optional<std::uint64_t> count = runs[run + 1].as_count();
    if (!first || !count || entry_bytes == 0 || *count > rest.size() / entry_bytes) return false;
    Section section = model;
    section.first = *first;
    section.count = *count;
    section.entries = std::string(rest.substr(0, static_cast<std::size_t>(*count) * entry_bytes));
    rest.remove_prefix(section.entries.size());
    table_bytes_ += section.entries.size();
    if (table_bytes_ > most_table_bytes) return false;
    sections_.push_back(std::move(section));
  }
  trailer = *dictionary;
  return true;
}

std::optional<PdfDocument::Placed> PdfDocument::object_at(std::uint64_t at) const {
  for (std::size_t window_bytes = first_window_bytes;; window_bytes *= 4) {
    const std::string window = pdf_->read(at, std::min(window_bytes, largest_window_bytes));
    PdfLexer lexer(window);
    std::optional<PdfObject> object = lexer.object();
    // An object that ends where the window does may go on behind it.
    const bool whole = window.size() < window_bytes;
    if (object && (whole || lexer.at() < window.size())) return Placed{*std::move(object), at + lexer.at()};
    if (whole || window_bytes >= largest_window_bytes) return std::nullopt;
  }
}

std::optional<PdfDocument::Placed> PdfDocument::numbered_object_at(std::uint64_t at,
                                                                   std::optional<std::uint64_t> number) const {
  if (at >= pdf_->size) return std::nullopt;
  const std::string head = pdf_->read(begin_ + at, 64);
  PdfLexer lexer(head);
  const std::optional<std::uint64_t> found = lexer.take_count();
  if (!found || (number && *found != *number) || !lexer.take_count() || !lexer.take_word("obj")) return std::nullopt;
  return object_at(begin_ + at + lexer.at());
}

std::optional<std::string> PdfDocument::stream_bytes(const Placed& stream, int links_left) const {
  const PdfDictionary* dictionary = stream.object.as<PdfDictionary>();
  const std::string head = pdf_->read(stream.end, 64);
  PdfLexer lexer(head);
  if (dictionary == nullptr || !lexer.take_word("stream")) return std::nullopt;
  std::size_t begin = lexer.at();
  if (head.substr(begin, 1) == "\r") ++begin;
  if (head.substr(begin, 1) == "\n") ++begin;
  const PdfObject* length = dictionary->find("Length");
  const std::optional<PdfObject> number = length == nullptr ? std::nullopt : resolved(*length, links_left - 1);
  const std::optional<std::uint64_t> bytes = number ? number->as_count() : std::nullopt;
  if (!bytes || *bytes > largest_stream_bytes) return std::nullopt;
  std::string data = pdf_->read(stream.end + begin, static_cast<std::size_t>(*bytes));
  return data.size() < *bytes ? std::nullopt : unpacked(std::move(data), *dictionary);
}

std::optional<PdfDocument::Place> PdfDocument::place_of(std::uint64_t number) const {
  for (const Section& section : sections_) {
    if (number < section.first || number - section.first >= section.count) continue;
    const std::uint64_t index = number - section.first;
    if (section.entries.empty()) {
      const std::string entry = pdf_->read(section.table_at + index * table_entry_bytes, table_entry_bytes);
      PdfLexer lexer(entry);
      const std::optional<std::uint64_t> offset = lexer.take_count();
      const bool in_use = offset && lexer.take_count() && lexer.take_word("n");
      // A free object may be hidden in a stream that an older section knows.
      if (!in_use) continue;
      return Place(*offset);
    }
    const auto& [type_bytes, offset_bytes, last_bytes] = section.widths;
    const std::size_t entry_bytes = type_bytes + offset_bytes + last_bytes;
    const std::string_view entry =
        std::string_view(section.entries).substr(static_cast<std::size_t>(index) * entry_bytes, entry_bytes);
    const std::uint64_t type = type_bytes == 0 ? 1 : big_endian(entry.substr(0, type_bytes));
    const std::uint64_t offset = big_endian(entry.substr(type_bytes, offset_bytes));
    if (type == 1) return Place(offset);
    if (type == 2) return Place(InStream{offset, big_endian(entry.substr(type_bytes + offset_bytes))});
  }
  return std::nullopt;
}

/// An object stream: /N pairs "number offset", then at /First the objects.
std::optional<PdfObject> PdfDocument::object_in(const InStream& place, std::uint64_t number, int links_left) const {
  const std::optional<Place> stream_place = place_of(place.stream);
  const std::uint64_t* at = stream_place ? std::get_if<std::uint64_t>(&*stream_place) : nullptr;
  const std::optional<Placed> placed = at == nullptr ? std::nullopt : numbered_object_at(*at, place.stream);
  const std::optional<std::string> bytes = placed ? stream_bytes(*placed, links_left) : std::nullopt;
  if (!bytes) return std::nullopt;
  const std::optional<std::uint64_t> first = count_in(*placed->object.as<PdfDictionary>(), "First");
  PdfLexer head(*bytes);
  for (std::uint64_t index = 0; first; ++index) {
    const std::optional<std::uint64_t> found = head.take_count();
    const std::optional<std::uint64_t> offset = head.take_count();
    if (!found || !offset) return std::nullopt;
    if (index != place.index && *found != number) continue;
    if (*found != number || *offset > bytes->size() || *first > bytes->size()) return std::nullopt;
    return PdfLexer(*bytes, static_cast<std::size_t>(*first + *offset)).object();
  }
  return std::nullopt;
}

std::optional<PdfObject> PdfDocument::resolved(const PdfObject& object, int links_left) const {
  const PdfReference* reference = object.as<PdfReference>();
  if (reference == nullptr) return object;
  const std::optional<Place> place = place_of(reference->number);
  if (!place || links_left <= 0) return std::nullopt;
  if (const InStream* in_stream = std::get_if<InStream>(&*place)) {
    const std::optional<PdfObject> found = object_in(*in_stream, reference->number, links_left - 1);
    return found ? resolved(*found, links_left - 1) : std::nullopt;
  }
  const std::optional<Placed> placed = numbered_object_at(std::get<std::uint64_t>(*place), reference->number);
  return placed ? resolved(placed->object, links_left - 1) : std::nullopt;
}

}  // namespace burin::cli
