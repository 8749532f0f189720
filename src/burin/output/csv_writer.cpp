#include <array>
#include <charconv>
#include <map>
#include <string>
#include <string_view>

#include <burin/base/check.hpp>
#include <burin/output/byte_writer.hpp>
#include <burin/output/csv_writer.hpp>

namespace burin::output {

namespace {

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

class CsvSink final : public OutputSink {
 public:
  CsvSink(ByteSink& bytes, const Sheet& sheet) : sheet_(sheet), out_(bytes) { out_.add("layer,path,x,y\n"); }

  Flow begin(const PathHead& head) override {
    BURIN_EXPECT(head.layer < sheet_.layers.size());
    head_ = head;
    begin_contour();
    return flow();
  }

  Flow points(std::span<const Vec2> points) override {
    if (!drawn()) return flow();
    if (!has_points_) first_ = points.front();
    has_points_ = true;
    for (const Vec2 p : points) add_row(p);
    return flow();
  }

  Flow contour() override {
    end_contour();
    begin_contour();
    return flow();
  }

  Flow end() override {
    end_contour();
    return flow();
  }

  Result<Done> finish() override { return out_.finish(); }

 private:
  bool drawn() const { return head_.role != Role::mask; }
  Flow flow() const { return out_.ok() ? Flow::go : Flow::stop; }

  void begin_contour() {
    has_points_ = false;
    if (!drawn()) return;
    const std::string& name = sheet_.layers[head_.layer].name;
    row_begin_ = csv_field(name) + ',' + std::to_string(paths_of_name_[name]++) + ',';
  }

  void end_contour() {
    if (head_.closed && has_points_) add_row(first_);
  }

  void add_row(Vec2 p) {
    std::array<char, 64> row;  // two doubles take 24 characters each at most
    char* end = std::to_chars(row.data(), row.data() + 30, p.x + 0.0).ptr;  // + 0.0: no "-0"
    *end++ = ',';
    end = std::to_chars(end, row.data() + row.size(), p.y + 0.0).ptr;
    *end++ = '\n';
    out_.add(row_begin_);
    out_.add({row.data(), static_cast<std::size_t>(end - row.data())});
  }

  const Sheet& sheet_;
  ByteWriter out_;
  std::map<std::string, std::uint64_t> paths_of_name_;
  PathHead head_;
  std::string row_begin_;
  bool has_points_ = false;
  Vec2 first_;
};

}  // namespace

std::unique_ptr<OutputSink> open_csv(ByteSink& bytes, const Sheet& sheet, const OutputOptions&) {
  return std::make_unique<CsvSink>(bytes, sheet);
}

}  // namespace burin::output
