#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/output/pdf/file.hpp>

namespace burin::output::pdf {

namespace {

/// Coordinates shrink by a sixth from level 1 to 6 at four times the time.
constexpr int deflate_level = 1;
/// An entry of the table has ten digits.
constexpr std::uint64_t largest_offset = 9'999'999'999;

}  // namespace

std::string reference(ObjectId id) {
  return fmt::format("{} 0 R", id);
}

File::File(ByteSink& bytes) : out_(bytes), deflate_(deflate_level) {
  // The second line is for programs that guess from high bytes whether a file is text.
  add("%PDF-1.5\n%\xE2\xE3\xCF\xD3\n");
}

void File::add(std::string_view text) {
  out_.add(text);
  size_ += text.size();
}

ObjectId File::reserve() {
  offsets_.push_back(0);
  return static_cast<ObjectId>(offsets_.size());
}

void File::begin(ObjectId id) {
  BURIN_EXPECT(id >= 1 && id <= offsets_.size() && offsets_[id - 1] == 0);
  offsets_[id - 1] = size_;
  add(fmt::format("{} 0 obj\n", id));
}

void File::object(ObjectId id, std::string_view body) {
  begin(id);
  add(body);
  add("\nendobj\n");
}

void File::stream(ObjectId id, std::string_view entries, std::string_view data) {
  plain_stream(id, fmt::format("{}/Filter/FlateDecode", entries), deflate_(data));
}

void File::plain_stream(ObjectId id, std::string_view entries, std::string_view data) {
  begin(id);
  add(fmt::format("<<{}/Length {}>>\nstream\n", entries, data.size()));
  add(data);
  add("\nendstream\nendobj\n");
}

Result<Done> File::finish(ObjectId catalog, ObjectId info, std::string_view identifier) {
  const std::uint64_t table_at = size_;
  if (table_at > largest_offset) {
    return Problem{{}, "the PDF grows beyond 10 GB, which its table cannot say: draw fewer points", Trouble::limit};
  }
  add(fmt::format("xref\n0 {}\n0000000000 65535 f \n", offsets_.size() + 1));
  for (const std::uint64_t offset : offsets_) {
    BURIN_EXPECT(offset > 0);
    add(fmt::format("{:010} 00000 n \n", offset));
  }
  add(fmt::format("trailer\n<</Size {0}/Root {1}/Info {2}/ID[<{3}><{3}>]>>\nstartxref\n{4}\n%%EOF\n",
                  offsets_.size() + 1, reference(catalog), reference(info), identifier, table_at));
  return out_.finish();
}

}  // namespace burin::output::pdf
