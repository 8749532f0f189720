#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/output/byte_writer.hpp>
#include <burin/output/path_data.hpp>
#include <burin/output/svg_document.hpp>
#include <burin/output/svg_uses.hpp>
#include <burin/output/svg_writer.hpp>

namespace burin::output {

namespace {

constexpr std::size_t packed_segments = 1000;
constexpr std::size_t longest_stroke = 30'000;
/// libxml2 gives up when its reading buffer grows beyond 10^7 bytes, and it empties the buffer only when it happens to
/// run dry between two elements. So no attribute is longer than this, and after so many bytes comes a line of blanks
/// longer than its reading step of 4000 bytes, in which it must run dry.
constexpr std::size_t longest_attribute = 7'000'000;
constexpr std::size_t bytes_between_rests = 2'000'000;
constexpr std::size_t rest_blanks = 4096;

/// An element is a <path>; it holds pieces. A piece is a contour or, of a stroke that is too long for one element, a
/// part of it. A piece's text waits until its length tells which element it goes to.
class SvgSink final : public OutputSink {
 public:
  SvgSink(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options)
      : sheet_(sheet), out_(bytes), data_(options.decimals) {
    if (options.defs) uses_.emplace(options.decimals);
    out_.add(svg_head(sheet, options));
  }

  Flow begin(const PathHead& head) override;
  Flow points(std::span<const Vec2> points) override;
  Flow contour() override;
  Flow end() override;
  Flow place(const PathHead& head, const Figure& figure, const Affine2& at) override;
  Result<Done> finish() override;
  std::uint64_t skipped_points() const override { return skipped_points_; }

 private:
  bool drawn() const { return head_.role != Role::mask; }
  Flow flow() const { return out_.ok() && !problem_ ? Flow::go : Flow::stop; }

  void go_to_layer(std::size_t layer);
  void begin_piece(GridPoint start);
  void draw(std::span<const Vec2> points);
  bool piece_is_full() const;
  void settle_piece();
  void end_contour();
  void end_element();
  void rest_after(std::size_t bytes);
  void spill_text();

  const Sheet& sheet_;
  ByteWriter out_;
  PathData data_;
  std::optional<SvgUses> uses_;
  std::optional<Problem> problem_;
  std::uint64_t skipped_points_ = 0;
  std::size_t layers_begun_ = 0;  ///< the last of them is open

  PathHead head_;         ///< of the path that is drawn
  bool may_cut_ = false;  ///< a cut of this path would not show
  bool contour_has_points_ = false;
  bool contour_is_cut_ = false;
  GridPoint contour_start_;

  GridPoint piece_start_;
  std::size_t piece_segments_ = 0;
  bool piece_is_settled_ = false;  ///< its element is known and its move is written
  std::array<char, (packed_segments + 2) * PathData::longest_command> text_;
  std::size_t text_size_ = 0;

  bool in_element_ = false;
  Paint element_paint_ = Paint::stroke;
  std::size_t element_segments_ = 0;
  std::size_t element_bytes_ = 0;
  std::size_t bytes_since_rest_ = 0;
  GridPoint element_at_;  ///< where the pen is after what is written
};

Flow SvgSink::begin(const PathHead& head) {
  BURIN_EXPECT(head.layer < sheet_.layers.size() && head.layer + std::size_t{1} >= layers_begun_);
  head_ = head;
  contour_has_points_ = false;
  if (!drawn()) return flow();
  if (head.layer >= layers_begun_) go_to_layer(head.layer);
  if (head.paint != Paint::stroke || element_paint_ != Paint::stroke) end_element();
  const SheetLayer& style = sheet_.layers[head.layer];
  may_cut_ =
      head.paint == Paint::stroke && style.cap == Cap::round && style.join == Join::round && style.dashes_mm.empty();
  return flow();
}

Flow SvgSink::contour() {
  if (drawn()) end_contour();
  contour_has_points_ = false;
  return flow();
}

Flow SvgSink::end() {
  if (drawn()) end_contour();
  return flow();
}

Flow SvgSink::points(std::span<const Vec2> points) {
  if (!drawn() || points.empty() || flow() == Flow::stop) return flow();
  if (!can_be_rounded(points)) {
    problem_ = coordinate_problem();
    return Flow::stop;
  }
  if (!contour_has_points_) {
    contour_has_points_ = true;
    contour_is_cut_ = false;
    contour_start_ = data_.grid()(points.front());
    begin_piece(contour_start_);
    points = points.subspan(1);
  }
  while (!points.empty()) {
    if (piece_is_full()) {
      end_element();
      contour_is_cut_ = true;
      begin_piece(data_.at());
    }
    // What has no element yet ends where it must get one; what may be cut ends where it is cut.
    std::size_t room = packed_segments;
    if (!piece_is_settled_)
      room = packed_segments - piece_segments_;
    else if (may_cut_)
      room = std::min(room, longest_stroke - piece_segments_);
    const auto some = points.first(std::min(points.size(), room));
    draw(some);
    points = points.subspan(some.size());
  }
  return flow();
}

void SvgSink::begin_piece(GridPoint start) {
  data_.start(start);
  piece_start_ = start;
  piece_segments_ = 0;
  piece_is_settled_ = false;
}

void SvgSink::draw(std::span<const Vec2> points) {
  char* const to = text_.data() + text_size_;
  const PathData::Lines lines = data_.lines(to, points);
  text_size_ += static_cast<std::size_t>(lines.end - to);
  piece_segments_ += lines.count;
  skipped_points_ += points.size() - lines.count;
  if (piece_is_settled_) {
    spill_text();
  } else if (piece_segments_ == packed_segments) {
    settle_piece();
  }
}

bool SvgSink::piece_is_full() const {
  if (may_cut_) return piece_segments_ == longest_stroke;
  return head_.paint == Paint::stroke && piece_is_settled_ && element_bytes_ >= longest_attribute;
}

/// Finds the element that the piece belongs to and writes its move and what there is of its text.
void SvgSink::settle_piece() {
  const bool is_stroke = head_.paint == Paint::stroke;
  if (in_element_ && is_stroke && element_segments_ + piece_segments_ > packed_segments) end_element();
  if (!in_element_) {
    out_.add(svg_path_begin(sheet_, head_));
    in_element_ = true;
    element_paint_ = head_.paint;
    element_segments_ = 0;
    element_bytes_ = 0;
    element_at_ = {};
  }
  std::array<char, PathData::longest_command> move;
  const GridPoint by{piece_start_.x - element_at_.x, piece_start_.y - element_at_.y};
  const char* const end = data_.move(move.data(), by, text_.front());
  out_.add({move.data(), static_cast<std::size_t>(end - move.data())});
  spill_text();
  piece_is_settled_ = true;
}

void SvgSink::spill_text() {
  out_.add({text_.data(), text_size_});
  element_bytes_ += text_size_;
  text_size_ = 0;
}

void SvgSink::end_contour() {
  BURIN_EXPECT(contour_has_points_);
  const bool returns_by_hand = head_.closed && contour_is_cut_;
  const auto add = [&](PathData::Lines lines) {
    text_size_ = static_cast<std::size_t>(lines.end - text_.data());
    piece_segments_ += lines.count;
  };
  char* const to = text_.data() + text_size_;
  if (returns_by_hand) add(data_.line(to, contour_start_));
  const bool is_dot = piece_segments_ == 0 && !contour_is_cut_;
  if (is_dot) {
    // The only dot that librsvg, Inkscape and MuPDF all draw.
    add({std::copy_n("h0", 2, to), 1});
  }
  if (piece_segments_ == 0) return;  // the cut came at the contour's end
  const bool returns = head_.closed && !contour_is_cut_ && !is_dot;
  if (returns) {
    text_[text_size_++] = 'z';
    ++piece_segments_;
  }
  if (piece_is_settled_) {
    spill_text();
  } else {
    settle_piece();
  }
  element_segments_ += piece_segments_;
  element_at_ = returns ? piece_start_ : data_.at();
}

void SvgSink::end_element() {
  if (!in_element_) return;
  out_.add("\"/>\n");
  rest_after(element_bytes_);
  in_element_ = false;
  element_paint_ = Paint::stroke;
}

void SvgSink::rest_after(std::size_t bytes) {
  bytes_since_rest_ += bytes;
  if (bytes_since_rest_ < bytes_between_rests) return;
  out_.add(std::string(rest_blanks, ' ') + '\n');
  bytes_since_rest_ = 0;
}

Flow SvgSink::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  if (!uses_ || head.role == Role::mask) return PathSink::place(head, figure, at);
  const std::string shown = uses_->show(figure, at, sheet_.layers[head.layer].paint);
  if (shown.empty()) return PathSink::place(head, figure, at);
  if (head.layer >= layers_begun_) go_to_layer(head.layer);
  end_element();
  out_.add(shown);
  rest_after(shown.size());
  return flow();
}

void SvgSink::go_to_layer(std::size_t layer) {
  end_element();
  if (layers_begun_ > 0) out_.add("</g>\n");
  for (; layers_begun_ < layer; ++layers_begun_) out_.add(svg_layer_begin(sheet_, layers_begun_, true));
  if (layer < sheet_.layers.size()) out_.add(svg_layer_begin(sheet_, layers_begun_++, false));
}

Result<Done> SvgSink::finish() {
  if (problem_) return *problem_;
  go_to_layer(sheet_.layers.size());
  out_.add("</svg>\n");
  return out_.finish();
}

}  // namespace

double svg_tolerance_mm(const Sheet&, const OutputOptions& options) {
  return half_unit_mm(options.decimals);
}

Result<Done> svg_accepts(const Sheet& sheet, const OutputOptions& options) {
  if (options.decimals < 0 || options.decimals > 6) {
    return Problem{{}, fmt::format("{} decimals are asked for; an SVG has from 0 to 6", options.decimals)};
  }
  constexpr double largest_page_mm = 20'000.0;
  const Page& page = sheet.page;
  if (!(page.width_mm > 0.0 && page.height_mm > 0.0)) {
    return Problem{
        {}, fmt::format("the page is {} x {} mm; both sides must be more than 0", page.width_mm, page.height_mm)};
  }
  if (page.width_mm > largest_page_mm || page.height_mm > largest_page_mm) {
    return Problem{{},
                   fmt::format("the page is {} x {} mm; the largest that can be written is 20 m a side: choose a "
                               "smaller page",
                               page.width_mm, page.height_mm),
                   Trouble::limit};
  }
  return Done{};
}

std::unique_ptr<OutputSink> open_svg(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options) {
  return std::make_unique<SvgSink>(bytes, sheet, options);
}

}  // namespace burin::output
