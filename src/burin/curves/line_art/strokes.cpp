#include <algorithm>
#include <cmath>

#include <burin/base/math.hpp>
#include <burin/curves/line_art/draws.hpp>
#include <burin/curves/line_art/strokes.hpp>

namespace burin::curves::line_art {

namespace {

double length_of(const std::vector<Vec2>& points) {
  double total = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) total += distance(points[i - 1], points[i]);
  return total;
}

Spot spot_of(const std::vector<Vec2>& points, std::uint64_t line, double depth, std::uint64_t seed) {
  const Vec2 chord = points.back() - points.front();
  return {points.front(),
          0.0,
          static_cast<double>(line),
          uniform(seed, draws::chance, line),
          length(chord),
          math::atan2(chord.y, chord.x) / math::radians_per_degree,
          depth};
}

}  // namespace

Strokes::Strokes(const Composition& composition, Meet meet, std::uint64_t seed)
    : composition_(composition), meet_(composition.meet.value_or(meet)), seed_(seed) {
  if (composition_.spacing > 0.0) neighbours_.emplace(composition_.spacing);
  if (composition_.tone) tone_.emplace(composition_.tone, *composition_.pen_width);
  if (composition_.budget) left_ = *composition_.budget;
}

std::span<const std::vector<Vec2>> Strokes::of(std::uint64_t line, std::vector<Vec2>& points, double depth) {
  stroke_count_ = 0;
  if (spent() || points.size() < 2) return {};
  if (composition_.density || composition_.kind) {
    const Spot spot = spot_of(points, line, depth, seed_);
    // A density that is no number draws nothing.
    if (composition_.density && !(uniform(seed_, draws::density, line) < composition_.density(spot))) return {};
    const double kind = composition_.kind ? std::floor(composition_.kind(spot)) : 0.0;
    constexpr double last_kind = std::numeric_limits<std::uint16_t>::max();
    kind_ = kind > 0.0 ? static_cast<std::uint16_t>(std::min(kind, last_kind)) : std::uint16_t{0};
  }
  smooth(points, composition_.smooth, composition_.smooth_levels, spare_);
  if (composition_.keeps_all()) return {&points, 1};

  is_cut_ = false;
  cut_by_shapes(points);
  for (std::size_t part = 0; part < part_count_; ++part) cut_by_strokes(parts_[part]);
  if (meet_ == Meet::drop && is_cut_) {
    stroke_count_ = 0;
    if (tone_) tone_->give_back(0);
  }
  if (tone_) tone_->keep();
  for (std::size_t s = 0; s < stroke_count_; ++s) {
    left_ -= length_of(strokes_[s]);
    if (!neighbours_) continue;
    for (std::size_t i = 1; i < strokes_[s].size(); ++i) neighbours_->add(strokes_[s][i - 1], strokes_[s][i]);
  }
  return std::span<const std::vector<Vec2>>(strokes_).first(stroke_count_);
}

bool Strokes::may_be_at(Vec2 p) const {
  if (composition_.inside && !composition_.inside->contains(p)) return false;
  return std::none_of(composition_.keep_out.all.begin(), composition_.keep_out.all.end(),
                      [&](const Region& region) { return region.contains(p); });
}

std::vector<Vec2>& Strokes::fresh(std::vector<std::vector<Vec2>>& list, std::size_t& count) {
  if (count == list.size()) list.emplace_back();
  list[count].clear();
  return list[count++];
}

void Strokes::cut_by_shapes(const std::vector<Vec2>& points) {
  part_count_ = 0;
  if (!composition_.inside && composition_.keep_out.all.empty()) {
    fresh(parts_, part_count_) = points;
    return;
  }
  std::vector<Vec2>* part = nullptr;  // null: where no stroke may be
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 a = points[i];
    const Vec2 b = points[i + 1];
    crossings_.clear();
    if (composition_.inside) composition_.inside->add_crossings(a, b, crossings_);
    for (const Region& region : composition_.keep_out.all) region.add_crossings(a, b, crossings_);
    std::sort(crossings_.begin(), crossings_.end());
    crossings_.push_back(1.0);
    double before = 0.0;
    for (const double t : crossings_) {
      if (t == before) continue;
      if (may_be_at(lerp(a, b, 0.5 * (before + t)))) {
        if (part == nullptr) {
          part = &fresh(parts_, part_count_);
          part->push_back(lerp(a, b, before));
        }
        // A crossing inside the edge is no vertex of its own while the stroke goes on.
        if (before > 0.0 && part->size() > 1) part->pop_back();
        part->push_back(t == 1.0 ? b : lerp(a, b, t));
      } else {
        is_cut_ = true;
        if (meet_ != Meet::resume) return;
        part = nullptr;
      }
      before = t;
    }
  }
}

void Strokes::cut_by_strokes(const std::vector<Vec2>& part) {
  if (is_cut_ && meet_ == Meet::drop) return;
  bool drawing = false;
  std::size_t tone_mark = 0;
  for (std::size_t i = 0; i + 1 < part.size(); ++i) {
    const std::size_t mark = tone_ ? tone_->mark() : 0;
    const bool is_free =
        (!neighbours_ || neighbours_->is_free(part[i], part[i + 1])) && (!tone_ || tone_->take(part[i], part[i + 1]));
    if (is_free) {
      if (!drawing) {
        fresh(strokes_, stroke_count_).push_back(part[i]);
        tone_mark = mark;
      }
      strokes_[stroke_count_ - 1].push_back(part[i + 1]);
      drawing = true;
      continue;
    }
    is_cut_ = true;
    if (drawing) finish_stroke(tone_mark);
    drawing = false;
    if (meet_ != Meet::resume) return;
  }
  if (drawing) finish_stroke(tone_mark);
}

void Strokes::finish_stroke(std::size_t tone_mark) {
  const std::vector<Vec2>& stroke = strokes_[stroke_count_ - 1];
  if (length_of(stroke) < composition_.shortest) {
    --stroke_count_;
    if (tone_) tone_->give_back(tone_mark);
  } else if (tone_) {
    tone_->add_ends(stroke.front(), stroke.back());
  }
}

}  // namespace burin::curves::line_art
