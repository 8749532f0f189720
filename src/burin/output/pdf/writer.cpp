#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <burin/base/check.hpp>
#include <burin/base/number_text.hpp>
#include <burin/base/units.hpp>
#include <burin/output/pdf/document.hpp>
#include <burin/output/pdf/figures.hpp>
#include <burin/output/pdf/layer_style.hpp>
#include <burin/output/pdf/page.hpp>
#include <burin/output/pdf/pieces.hpp>
#include <burin/output/pdf/text.hpp>
#include <burin/output/pdf/writer.hpp>

namespace burin::output {

namespace {

constexpr std::size_t longest_piece = 1000;
/// Text that is compressed at once.
constexpr std::size_t chunk_bytes = std::size_t{1} << 18U;
/// Readers keep whole numbers in 32 bits.
constexpr double farthest_mm = 1e6;
/// 14400 points: viewers need not open longer pages (ISO 32000-1, annex C.2).
constexpr double longest_page_mm = 200.0 * mm_per_inch;

/// Whether the box, put on the page, is within what readers understand.
bool is_near(const Affine2& page_from_box, const Box2& box) {
  return std::ranges::all_of(std::array{box.low, box.high, Vec2{box.low.x, box.high.y}, Vec2{box.high.x, box.low.y}},
                             [&](Vec2 corner) {
                               const Vec2 p = page_from_box(corner);
                               return std::abs(p.x) <= farthest_mm && std::abs(p.y) <= farthest_mm;
                             });
}

class PdfSink final : public OutputSink {
 public:
  PdfSink(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options)
      : sheet_(sheet), unit_mm_(pdf::unit_mm(options.decimals)), document_(bytes, sheet), pieces_(options.decimals) {
    pieces_.add(pdf::page_begin(sheet.page, options.paper));
    const std::string unit = pdf::number_text(unit_mm_);
    pieces_.add(fmt::format("{0} 0 0 {0} 0 0 cm\n", unit));
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
  Flow flow() const { return document_.ok() && !problem_ ? Flow::go : Flow::stop; }

  const SheetLayer& style() const { return sheet_.layers[*layer_]; }
  bool in_group() const { return layer_ && style().opacity < 1.0; }
  void go_to_layer(LayerId layer);
  void enter_layer(LayerId layer);
  std::optional<pdf::Figures::Known> known_figure(const Figure& figure);
  void leave_layer();
  void end_contour();
  void draw_dot();
  void spill(std::size_t more_than);

  const Sheet& sheet_;
  double unit_mm_;
  pdf::Document document_;
  pdf::Pieces pieces_;
  pdf::Figures figures_;
  std::optional<Problem> problem_;
  std::uint64_t skipped_points_ = 0;

  std::optional<LayerId> layer_;
  PathHead head_;         ///< of the path that is drawn
  bool may_cut_ = false;  ///< a cut of this path would not show
  bool contour_has_points_ = false;
  bool contour_moved_ = false;
  bool contour_is_cut_ = false;
  GridPoint contour_start_;
};

Flow PdfSink::begin(const PathHead& head) {
  head_ = head;
  contour_has_points_ = false;
  if (!drawn()) return flow();
  go_to_layer(head.layer);
  pieces_.begin_path(head.paint);
  may_cut_ = head.paint == Paint::stroke && style().cap == Cap::round && style().join == Join::round &&
             !pdf::is_dashed(style());
  return flow();
}

Flow PdfSink::contour() {
  if (drawn()) end_contour();
  contour_has_points_ = false;
  return flow();
}

Flow PdfSink::end() {
  if (!drawn()) return flow();
  end_contour();
  if (head_.paint != Paint::stroke) pieces_.end_piece();
  spill(chunk_bytes);
  return flow();
}

Flow PdfSink::points(std::span<const Vec2> points) {
  if (!drawn() || points.empty() || flow() == Flow::stop) return flow();
  const bool far =
      !std::ranges::all_of(points, [](Vec2 p) { return std::abs(p.x) <= farthest_mm && std::abs(p.y) <= farthest_mm; });
  if (far) {
    problem_ = Problem{{},
                       "a point lies more than a kilometre from the page, which not every reader of PDF understands: "
                       "draw at a smaller scale or crop the drawing",
                       Trouble::limit};
    return Flow::stop;
  }
  if (!contour_has_points_) {
    contour_has_points_ = true;
    contour_moved_ = false;
    contour_is_cut_ = false;
    contour_start_ = pieces_.grid()(points.front());
    pieces_.start(contour_start_);
    points = points.subspan(1);
  }
  while (!points.empty()) {
    if (may_cut_ && pieces_.segments() >= longest_piece) {
      contour_is_cut_ = contour_moved_;
      pieces_.end_piece();
      pieces_.start(pieces_.at());
    }
    const std::size_t room = may_cut_ ? longest_piece - pieces_.segments() : longest_piece;
    const auto some = points.first(std::min(points.size(), room));
    const std::size_t lines = pieces_.lines(some);
    contour_moved_ = contour_moved_ || lines > 0;
    skipped_points_ += some.size() - lines;
    points = points.subspan(some.size());
    spill(chunk_bytes);
  }
  return flow();
}

void PdfSink::end_contour() {
  BURIN_EXPECT(contour_has_points_);
  if (!contour_moved_) {
    draw_dot();
  } else if (head_.closed && contour_is_cut_) {
    pieces_.line(contour_start_);
  } else if (head_.closed) {
    pieces_.close();
  }
  if (head_.paint == Paint::stroke && pieces_.segments() >= longest_piece) pieces_.end_piece();
}

/// A line of no length is a dot where ends are round and lines are full, and nothing where ends are butt; what else SVG
/// and our pictures show must be said otherwise (ISO 32000-1, 8.5.3.2).
void PdfSink::draw_dot() {
  const bool is_stroke = head_.paint == Paint::stroke;
  if (!is_stroke || style().cap == Cap::butt) return;
  if (style().cap == Cap::round && !pdf::is_dashed(style())) {
    pieces_.dot();
    return;
  }
  pieces_.end_piece();
  const double width = sheet_.pens[style().pen].width_mm / unit_mm_;
  const double shift = style().cap == Cap::square ? 0.5 * width : 0.0;
  const auto units = [&](std::int64_t grid) {
    return static_cast<double>(grid) * 2.0 * half_unit_mm(pieces_.grid().decimals()) / unit_mm_ - shift;
  };
  const std::string place = pdf::number_text(units(contour_start_.x)) + ' ' + pdf::number_text(units(contour_start_.y));
  if (style().cap == Cap::square) {
    pieces_.add(fmt::format("{0} {1} {1} re f\n", place, pdf::number_text(width)));
  } else {
    pieces_.add(fmt::format("q [] 0 d {0} m {0} l S Q\n", place));
  }
}

/// Hands the text over when it has grown. Within a group a chunk ends between two pieces.
void PdfSink::spill(std::size_t more_than) {
  if (pieces_.text().size() <= more_than || (in_group() && pieces_.is_open())) return;
  document_.add_chunk(pieces_.text());
  pieces_.clear();
}

/// Strokes keep the pen's width whatever the figure's size, so only a figure that keeps its shape can be a form.
Flow PdfSink::place(const PathHead& head, const Figure& figure, const Affine2& at) {
  if (head.role == Role::mask || flow() == Flow::stop) return flow();
  const Box2& bounds = figure.bounds();
  const double reach_mm = pdf::reach(bounds) * at.scale();
  const double unit_in_form_mm = reach_mm / pdf::form_size;
  const bool exact = unit_in_form_mm <= half_unit_mm(pieces_.grid().decimals());
  const bool fits = sheet_.pens[sheet_.layers[head.layer].pen].width_mm <= reach_mm;
  const std::optional<pdf::Figures::Known> known =
      exact && fits && is_similarity(at) && is_near(at, bounds) ? known_figure(figure) : std::nullopt;
  if (!known) return PathSink::place(head, figure, at);
  go_to_layer(head.layer);
  pieces_.end_piece();
  const double shrink = 1.0 / (known->units_per_figure_unit * unit_mm_);
  constexpr int decimals = 12;
  const auto text = [](double value) { return pdf::number_text(value, decimals); };
  pieces_.add(fmt::format("q {} {} {} {} {} {} cm {}/F{} Do Q\n", text(shrink * at.a), text(shrink * at.b),
                          text(shrink * at.c), text(shrink * at.d), pdf::number_text(at.e / unit_mm_, 3),
                          pdf::number_text(at.f / unit_mm_, 3),
                          pdf::stroke_lengths(sheet_, head.layer, unit_in_form_mm), known->index));
  spill(chunk_bytes);
  return flow();
}

/// The figure's form, which is written when it comes for the first time; nothing when it has none.
std::optional<pdf::Figures::Known> PdfSink::known_figure(const Figure& figure) {
  if (const std::optional<pdf::Figures::Known> known = figures_.find(figure)) return known;
  if (!figures_.has_room_for(figure)) return std::nullopt;
  const std::optional<pdf::FigureForm> form = pdf::figure_form(figure);
  if (!form) return std::nullopt;
  document_.add_figure(form->operators);
  return figures_.add(figure, form->units_per_figure_unit);
}

void PdfSink::go_to_layer(LayerId layer) {
  BURIN_EXPECT(layer < sheet_.layers.size() && layer >= layer_.value_or(0));
  if (layer_ != layer) enter_layer(layer);
}

void PdfSink::enter_layer(LayerId layer) {
  leave_layer();
  pieces_.add(pdf::layer_begin(layer) + pdf::layer_style(sheet_, layer, unit_mm_));
  if (sheet_.layers[layer].opacity < 1.0) {
    spill(0);
    document_.begin_group(unit_mm_);
  }
  layer_ = layer;
}

void PdfSink::leave_layer() {
  if (!layer_) return;
  pieces_.end_piece();
  if (in_group()) {
    spill(0);
    pieces_.add(document_.end_group(style().opacity));
  }
  pieces_.add(pdf::layer_end());
  layer_.reset();
}

Result<Done> PdfSink::finish() {
  if (problem_) return *problem_;
  leave_layer();
  spill(0);
  return document_.finish();
}

}  // namespace

double pdf_tolerance_mm(const Sheet&, const OutputOptions& options) {
  return half_unit_mm(options.decimals);
}

Result<Done> pdf_accepts(const Sheet& sheet, const OutputOptions& options) {
  if (options.decimals < 0 || options.decimals > 6) {
    return Problem{{}, fmt::format("{} decimals are asked for; a PDF has from 0 to 6", options.decimals)};
  }
  const Page& page = sheet.page;
  if (!(page.width_mm > 0.0 && page.height_mm > 0.0)) {
    return Problem{{},
                   fmt::format("the page is {} x {} mm; both sides must be more than 0", fixed_text(page.width_mm, 3),
                               fixed_text(page.height_mm, 3))};
  }
  const double around_mm = 2.0 * pdf::page_surround_mm(page);
  if (std::max(page.width_mm, page.height_mm) + around_mm <= longest_page_mm) return Done{};
  return Problem{{},
                 fmt::format("a PDF page of {} x {} mm{} is more than viewers open; a side can have {} mm: make the "
                             "page smaller, or write SVG",
                             fixed_text(page.width_mm, 3), fixed_text(page.height_mm, 3),
                             around_mm > 0.0 ? " with bleed and crop marks" : "", fixed_text(longest_page_mm, 3)),
                 Trouble::limit};
}

std::unique_ptr<OutputSink> open_pdf(ByteSink& bytes, const Sheet& sheet, const OutputOptions& options) {
  return std::make_unique<PdfSink>(bytes, sheet, options);
}

}  // namespace burin::output
