#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <burin/output/byte_writer.hpp>
#include <burin/output/deflate.hpp>

namespace burin::output::pdf {

/// The number of an indirect object, from 1.
using ObjectId = std::uint32_t;

/// "7 0 R".
std::string reference(ObjectId id);

/// A PDF file as a row of objects, written as they come, and the table at its end that finds them. A failed write is
/// kept until finish(). Memory: 8 bytes an object and twice the longest stream.
///
/// Source: ISO 32000-1:2008, section 7.5.
class File {
 public:
  /// Writes the header. `bytes` must outlive the file.
  explicit File(ByteSink& bytes);

  /// The number of an object that is written later. Each must be, before finish().
  ObjectId reserve();
  /// `body`: the object itself, for example "<</Type/Pages>>".
  void object(ObjectId id, std::string_view body);
  /// A stream whose data are deflated; `entries`: what its dictionary says besides, without the brackets.
  void stream(ObjectId id, std::string_view entries, std::string_view data);
  /// The same as it is, for programs that look for text in files.
  void plain_stream(ObjectId id, std::string_view entries, std::string_view data);

  bool ok() const { return out_.ok(); }

  /// Writes the table. `identifier`: 32 hexadecimal digits that tell this file from others.
  Result<Done> finish(ObjectId catalog, ObjectId info, std::string_view identifier);

 private:
  void add(std::string_view text);
  void begin(ObjectId id);

  ByteWriter out_;
  Deflater deflate_;
  std::uint64_t size_ = 0;
  std::vector<std::uint64_t> offsets_;  ///< of object 1, 2, ...; 0: not written
};

}  // namespace burin::output::pdf
