#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <burin/base/result.hpp>
#include <cli/recover/bytes_at.hpp>
#include <cli/recover/pdf_object.hpp>

namespace burin::cli {

/// A PDF whose objects can be looked up by number: cross-reference tables and streams, incremental updates, object
/// streams. Only what is asked for is read.
class PdfDocument {
 public:
  /// A problem says which part of the file's skeleton could not be read. `pdf` must outlive the document.
  static Result<PdfDocument> open(const BytesAt& pdf, const std::string& shown);

  /// The newest trailer's entry of this name, or null.
  const PdfObject* trailer_entry(std::string_view key) const;

  /// The object, following references; nothing when the file has it not, or damaged.
  std::optional<PdfObject> resolved(const PdfObject& object) const { return resolved(object, longest_chain); }

 private:
  /// How many objects may be read to find one: references to references, lengths of streams.
  static constexpr int longest_chain = 16;

  /// Where an object is: at an offset, or by index in an object stream.
  struct InStream {
    std::uint64_t stream = 0;
    std::uint64_t index = 0;
  };
  using Place = std::variant<std::uint64_t, InStream>;

  /// A run of entries of a cross-reference table, which stays in the file, or of an unpacked stream.
  struct Section {
    std::uint64_t first = 0;  ///< object number
    std::uint64_t count = 0;
    std::uint64_t table_at = 0;           ///< of a table: offset of its first entry
    std::string entries{};                ///< of a stream: the entries
    std::array<std::size_t, 3> widths{};  ///< of a stream: bytes of type, offset and generation
  };

  /// An object read at an offset, and where what follows it begins.
  struct Placed {
    PdfObject object;
    std::uint64_t end = 0;
  };

  explicit PdfDocument(const BytesAt& pdf) : pdf_(&pdf) {}

  std::optional<std::uint64_t> last_table() const;
  bool read_table(std::uint64_t at, PdfDictionary& trailer);
  bool read_table_stream(std::uint64_t at, PdfDictionary& trailer);
  std::optional<Placed> object_at(std::uint64_t at) const;
  /// "7 0 obj ..." at this offset; the number must be `number` if given.
  std::optional<Placed> numbered_object_at(std::uint64_t at, std::optional<std::uint64_t> number) const;
  std::optional<PdfObject> resolved(const PdfObject& object, int links_left) const;
  std::optional<std::string> stream_bytes(const Placed& stream, int links_left) const;
  std::optional<Place> place_of(std::uint64_t number) const;
  std::optional<PdfObject> object_in(const InStream& place, std::uint64_t number, int links_left) const;

  const BytesAt* pdf_;
  std::uint64_t begin_ = 0;              ///< of the header: offsets count from here
  std::vector<Section> sections_;        ///< newest first
  std::size_t table_bytes_ = 0;          ///< held by the sections
  std::vector<PdfDictionary> trailers_;  ///< newest first
};

}  // namespace burin::cli
