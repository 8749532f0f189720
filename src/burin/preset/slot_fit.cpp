#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <burin/base/number_text.hpp>
#include <burin/path/decorators.hpp>
#include <burin/preset/layer_facts.hpp>
#include <burin/preset/layer_run.hpp>
#include <burin/preset/slot_fit.hpp>

namespace burin::preset {

namespace {

/// Most points a curve is run through before its size is known.
constexpr double most_points_unbounded = 5e7;

/// Why the layer's curve has no finite box, in words for the user.
Problem no_box(const Layer& layer, std::uint64_t seed) {
  const double asked = layer.family->forecast(layer.parameters, {.seed = seed}, 0.0).asked_points;
  if (asked > most_points_unbounded) {
    return {{},
            fmt::format("its curve cannot be fitted to the page: it has {} points, and all of them would have to be "
                        "drawn to know its size; lower '{}'",
                        count_text(asked), layer.family->cost_knob),
            Trouble::limit,
            {}};
  }
  return {{},
          "its curve cannot be fitted to the page: a point of it is not a number, or too far away to compute with; "
          "check its numbers and expressions",
          Trouble::input,
          {}};
}

Problem too_many_to_remember(const Layer& layer) {
  return {{},
          fmt::format("'distinct' and 'apart' remember at most {} places; lower '{}' or leave them out",
                      count_text(static_cast<double>(primitives::Spacing::most_points)), layer.family->cost_knob),
          Trouble::limit,
          {}};
}

/// The layers of a slot, measured again and again while a scale is looked for.
class SlotContent {
 public:
  SlotContent(const Piece& piece, const std::string& name, const SlotFrame& frame) : piece_(piece), frame_(frame) {
    for (const Layer& layer : piece.layers) {
      if (layer.style.slot != name) continue;
      layers_.push_back(&layer);
      inset_mm_ = std::max(inset_mm_, half_widest_pen_mm(piece, layer));
      const std::optional<primitives::PlacingSpec>& placing = layer.style.primitives;
      has_figures_ = has_figures_ || placing;
      cells_differ_ = cells_differ_ || uses_seed(layer) || (placing && primitives::depends_on_slot(*placing));
    }
  }

  double inset_mm() const { return inset_mm_; }
  bool has_figures() const { return has_figures_; }

  /// With null, of the curves alone; else with their figures, as large as these copies make them.
  Result<std::vector<Copy>> lay_out(const SlotSpec& slot, const std::vector<Copy>* copies) {
    const ContentBox content_box = [&](const Affine2& map, int cell) { return box(map, cell, copies); };
    Result<std::vector<Copy>> made = preset::lay_out(slot, frame_, inset_mm_, content_box);
    if (!problem_) return made;
    return *problem_;
  }

  /// Who is to blame for what went wrong last.
  const Layer& blamed() const { return blamed_ != nullptr ? *blamed_ : *layers_.front(); }

 private:
  std::optional<Box2> box(const Affine2& map, int cell, const std::vector<Copy>* copies) {
    Box2 content;
    if (cell > 0 && !cells_differ_) return content;  // nothing that cell 0 has not
    for (const Layer* layer : layers_) {
      const bool with_figures = copies != nullptr && layer->style.primitives;
      const std::optional<Box2> box =
          with_figures ? figures_box(*layer, map, cell, *copies) : curve_box(*layer, map, cell);
      if (!box || !(box->empty() || (is_finite(box->low) && is_finite(box->high)))) {
        blamed_ = layer;
        if (!problem_) problem_ = no_box(*layer, piece_.seed);
        return std::nullopt;
      }
      content.add(*box);
    }
    return content;
  }

  std::optional<Box2> curve_box(const Layer& layer, const Affine2& map, int cell) const {
    Box2 content;
    for (std::size_t level = 0; level < layer.level_count(); ++level) {
      const std::optional<Box2> box =
          layer.family->bounds(layer.level_parameters(level), {.seed = layer_seed(layer, piece_.seed, cell)}, map);
      if (!box) return std::nullopt;
      content.add(*box);
    }
    return content;
  }

  std::optional<Box2> figures_box(const Layer& layer, const Affine2& map, int cell, const std::vector<Copy>& copies) {
    const DrawContext context{.seed = layer_seed(layer, piece_.seed, cell)};
    for (std::size_t level = 0; level < layer.level_count(); ++level) {
      const Forecast points = layer.family->forecast(layer.level_parameters(level), context, most_points_unbounded);
      if (points.points > most_points_unbounded) return std::nullopt;
    }
    const auto copy = std::ranges::find_if(
        copies, [&](const Copy& each) { return each.cell == cell && each.upright_from_model == map; });
    BoundsSink sink;
    Mapped mapped(sink, map);
    bool overflowed = false;
    const LayerPart part = whole_layer(layer);
    passes::Regions::Item item = 0;
    const Flow flow =
        LayerRun(layer, part).draw(setting_of(frame_, *copy, context), context, mapped, item, &overflowed);
    if (overflowed) problem_ = too_many_to_remember(layer);
    if (overflowed || flow == Flow::stop || !sink.finite()) return std::nullopt;
    return sink.box();
  }

  const Piece& piece_;
  SlotFrame frame_;
  std::vector<const Layer*> layers_;
  double inset_mm_ = 0.0;
  bool has_figures_ = false;
  bool cells_differ_ = false;
  const Layer* blamed_ = nullptr;
  std::optional<Problem> problem_;
};

double scale_of(const std::vector<Copy>& copies) {
  return copies.front().slot_from_model.scale();
}

/// Finds the scale at which curves and figures fill the slot. What they take up grows almost linearly with the scale:
/// some figures' sizes grow along, others stay. Where it jumps, since figures come and go, the largest scale that was
/// seen to fit is taken.
Result<std::vector<Copy>> lay_out_figures(const SlotSpec& slot, SlotContent& content, std::vector<Copy> copies) {
  constexpr int most_steps = 16;
  constexpr double close_enough = 1e-7;
  double scale_before = 0.0;
  double filled_before = 0.0;
  std::vector<Copy> best;
  const auto pinned_to = [&](double scale, const std::vector<Copy>& measured) {
    SlotSpec pinned = slot;
    pinned.scale = params::Length{scale};
    return content.lay_out(pinned, &measured);
  };
  for (int step = 1;; ++step) {
    Result<std::vector<Copy>> fitted = content.lay_out(slot, &copies);
    if (!fitted || slot.scale) return fitted;
    const double scale = scale_of(copies);
    const double filled = scale / scale_of(*fitted);  // 1: just fits
    if (std::abs(filled - 1.0) <= close_enough) return fitted;
    if (filled < 1.0 && (best.empty() || scale > scale_of(best))) best = copies;
    if (step >= most_steps && !best.empty()) return pinned_to(scale_of(best), best);
    if (step >= 2 * most_steps) return fitted;
    double next = scale_of(*fitted);
    if (step >= most_steps) {
      next = 0.98 * scale;
    } else if (step > 1 && filled != filled_before) {
      const double secant = scale + (1.0 - filled) * (scale - scale_before) / (filled - filled_before);
      if (secant > 0.1 * next && secant < 10.0 * next) next = secant;
    }
    scale_before = scale;
    filled_before = filled;
    Result<std::vector<Copy>> moved = pinned_to(next, copies);
    if (!moved) return moved;
    copies = *std::move(moved);
  }
}

}  // namespace

Result<FittedSlot> fit_slot(const Piece& piece, const std::string& name) {
  const SlotSpec& slot = slot_called(piece, name);
  const SlotFrame frame = slot_frame(piece.page, slot);
  SlotContent content(piece, name, frame);
  Result<std::vector<Copy>> copies = content.lay_out(slot, nullptr);
  if (copies && content.has_figures()) copies = lay_out_figures(slot, content, *std::move(copies));
  if (copies) return FittedSlot{frame, *std::move(copies)};
  Problem problem = copies.problems().front();
  problem.where = content.blamed().where;
  problem.message = fmt::format("layer '{}': {}", content.blamed().style.name, problem.message);
  return problem;
}

}  // namespace burin::preset
