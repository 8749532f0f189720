#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>
#include <burin/base/sha256.hpp>
#include <burin/output/byte_writer.hpp>
#include <burin/output/dump_writer.hpp>
#include <burin/output/fixed_point.hpp>

namespace burin::output {

namespace {

constexpr int micrometre_decimals = 3;

std::string micrometres(double mm) {
  return fixed_text(1000.0 * mm, 0);
}

/// A name in quotes, on one line whatever is in it.
std::string quoted(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte == 0x7F ? fmt::format("\\x{:02x}", static_cast<unsigned>(byte)) : std::string(1, c);
  }
  return text + '"';
}

const char* word(Paint paint) {
  constexpr std::array words{"stroke", "fill-nonzero", "fill-evenodd"};
  return words[static_cast<std::size_t>(paint)];
}

const char* word(Cap cap) {
  constexpr std::array words{"round", "butt", "square"};
  return words[static_cast<std::size_t>(cap)];
}

const char* word(Join join) {
  constexpr std::array words{"round", "miter", "bevel"};
  return words[static_cast<std::size_t>(join)];
}

const char* word(Role role) {
  constexpr std::array words{"", " mask", " ink-and-mask"};
  return words[static_cast<std::size_t>(role)];
}

std::string tables_text(const Sheet& sheet) {
  const Page& page = sheet.page;
  std::string text = fmt::format("burin dump 1\npage {} {} bleed {} paper {}\n", micrometres(page.width_mm),
                                 micrometres(page.height_mm), micrometres(page.bleed_mm), colour_text(page.paper));
  std::size_t number = 0;
  for (const Pen& pen : sheet.pens) {
    text += fmt::format("pen {} {} {} {}\n", ++number, colour_text(pen.colour), micrometres(pen.width_mm),
                        quoted(pen.name));
  }
  number = 0;
  for (const SheetLayer& layer : sheet.layers) {
    text += fmt::format("layer {} {} pen {} {} cap {} join {} miter {} opacity {}", ++number, quoted(layer.name),
                        layer.pen + 1, word(layer.paint), word(layer.cap), word(layer.join),
                        fixed_text(layer.miter_limit, 3), fixed_text(layer.opacity, 3));
    if (!layer.dashes_mm.empty()) {
      text += " dashes";
      for (const double dash_mm : layer.dashes_mm) text += ' ' + micrometres(dash_mm);
      text += " offset " + micrometres(layer.dash_offset_mm);
    }
    text += '\n';
  }
  return text;
}

/// What is left of a layer when its paths are not shown.
struct Totals {
  std::uint64_t paths = 0;
  std::uint64_t contours = 0;
  std::uint64_t points = 0;
  GridPoint low{std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::max()};
  GridPoint high{std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min()};

  void add(GridPoint p) {
    ++points;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

/// Keeps a text while it is short; of a long one only its length and its hash.
class ShortText {
 public:
  void add(std::string_view text) {
    length_ += text.size();
    if (text_.size() + text.size() > dump_limit_bytes) {
      hash_.add(text_);
      text_.clear();
    }
    text_ += text;
  }
  bool is_whole() const { return length_ <= dump_limit_bytes; }
  std::uint64_t length() const { return length_; }
  const std::string& text() const { return text_; }
  /// Once, as the last.
  std::string hex_digest() {
    hash_.add(text_);
    return hash_.hex_digest();
  }

 private:
  std::string text_;
  std::uint64_t length_ = 0;
  Sha256 hash_;
};

class DumpSink final : public OutputSink {
 public:
  DumpSink(ByteSink& bytes, const Sheet& sheet)
      : out_(bytes), grid_(micrometre_decimals), totals_(sheet.layers.size()) {
    out_.add(tables_text(sheet));
  }

  Flow begin(const PathHead& head) override {
    BURIN_EXPECT(head.layer < totals_.size());
    layer_ = head.layer;
    ++totals_[layer_].paths;
    ++totals_[layer_].contours;
    paths_.add(fmt::format("path {} {} {}{}\n", layer_ + 1, word(head.paint), head.closed ? "closed" : "open",
                           word(head.role)));
    return Flow::go;
  }

  Flow points(std::span<const Vec2> points) override {
    if (!can_be_rounded(points)) {
      problem_ = coordinate_problem();
      return Flow::stop;
    }
    for (const Vec2 p : points) add_point(grid_(p));
    return Flow::go;
  }

  Flow contour() override {
    ++totals_[layer_].contours;
    paths_.add("contour\n");
    return Flow::go;
  }

  Flow end() override { return Flow::go; }

  Result<Done> finish() override {
    if (problem_) return *problem_;
    if (paths_.is_whole()) {
      out_.add(paths_.text());
    } else {
      out_.add(totals_text());
    }
    return out_.finish();
  }

 private:
  void add_point(GridPoint p) {
    totals_[layer_].add(p);
    std::array<char, 48> line;  // twice 17 characters at most
    char* end = std::to_chars(line.data(), line.data() + 22, p.x).ptr;
    *end++ = ' ';
    end = std::to_chars(end, line.data() + 46, p.y).ptr;
    *end++ = '\n';
    paths_.add({line.data(), static_cast<std::size_t>(end - line.data())});
  }

  std::string totals_text() {
    std::string text;
    for (std::size_t i = 0; i < totals_.size(); ++i) {
      const Totals& layer = totals_[i];
      text += fmt::format("total {} paths {} contours {} points {}", i + 1, layer.paths, layer.contours, layer.points);
      if (layer.points > 0) {
        text += fmt::format(" bounds {} {} {} {}", layer.low.x, layer.low.y, layer.high.x, layer.high.y);
      }
      text += '\n';
    }
    return text + fmt::format("paths {} bytes sha256 {}\n", paths_.length(), paths_.hex_digest());
  }

  ByteWriter out_;
  Grid grid_;
  std::vector<Totals> totals_;
  std::size_t layer_ = 0;
  ShortText paths_;
  std::optional<Problem> problem_;
};

}  // namespace

std::unique_ptr<OutputSink> open_dump(ByteSink& bytes, const Sheet& sheet, const OutputOptions&) {
  return std::make_unique<DumpSink>(bytes, sheet);
}

}  // namespace burin::output
