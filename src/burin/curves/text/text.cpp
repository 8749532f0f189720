#include <vector>

#include <burin/curves/text/layout.hpp>
#include <burin/curves/text/text.hpp>
#include <burin/path/decorators.hpp>

namespace burin::curves {

namespace {

using lettering::Glyph;
using lettering::Layout;
using lettering::Stroke;

/// The box of a letter in model units.
Box2 letter_box(const Layout& layout, const Layout::Letter& letter) {
  Box2 box;
  for (const Stroke& stroke : letter.glyph->strokes) {
    for (const Vec2 p : stroke) box.add(layout.point(p, letter.at));
  }
  return box;
}

/// Whether a letter leaves ink in the view.
bool is_seen(const Layout& layout, const Layout::Letter& letter, const View& view) {
  return !view.is_limited() || letter_box(layout, letter).touches(view.box);
}

Flow draw_letter(const Layout& layout, const Layout::Letter& letter, const PathHead& head, PathSink& sink) {
  std::vector<Vec2> points;
  for (const Stroke& stroke : letter.glyph->strokes) {
    points.clear();
    for (const Vec2 p : stroke) points.push_back(layout.point(p, letter.at));
    if (sink.begin(head) == Flow::stop || sink.points(points) == Flow::stop || sink.end() == Flow::stop) {
      return Flow::stop;
    }
  }
  return Flow::go;
}

Flow draw_seen(const TextParams& params, const DrawContext& context, const PathHead& head, PathSink& sink) {
  const Layout layout(params, context.origin);
  for (const Layout::Letter& letter : layout.letters()) {
    if (is_seen(layout, letter, context.view) && draw_letter(layout, letter, head, sink) == Flow::stop)
      return Flow::stop;
  }
  return Flow::go;
}

struct TextFamily {
  using Params = TextParams;

  static bool check(const Params&, const params::Table& table, params::ReadContext& context) {
    if (table.find("text") != nullptr) return true;
    const params::Value* family = table.find("family");
    context.report(family == nullptr ? Where{} : family->where, "a text needs 'text': what is written");
    return false;
  }

  static std::optional<Box2> bounds(const Params& params, const DrawContext&, const Affine2& frame) {
    return text_box(params, frame);
  }

  static Forecast forecast(const Params& params, const DrawContext& context, double) {
    Forecast forecast;
    const Layout layout(params, context.origin);
    for (const Layout::Letter& letter : layout.letters()) {
      const auto points = static_cast<double>(letter.glyph->point_count());
      forecast.asked_points += points;
      if (is_seen(layout, letter, context.view)) forecast.points += points;
    }
    return forecast;
  }

  static Flow draw(const Params& params, const DrawContext& context, PathSink& sink) {
    return draw_seen(params, context, {}, sink);
  }

  static bool uses_seed(const Params&) { return false; }
};

}  // namespace

Family text_family() {
  return make_family<TextFamily>("text", "letters of single strokes for titles and captions, from the Hershey fonts",
                                 "A. V. Hershey, Calligraphy for Computers, U. S. Naval Weapons Laboratory, 1967",
                                 "text");
}

Flow draw_text(const TextParams& params, const Affine2& sink_from_model, const PathHead& head, PathSink& sink) {
  Mapped mapped(sink, sink_from_model);
  return draw_seen(params, {}, head, mapped);
}

Box2 text_box(const TextParams& params, const Affine2& sink_from_model) {
  BoundsSink bounds;
  Mapped mapped(bounds, sink_from_model);
  static_cast<void>(draw_seen(params, {}, {}, mapped));
  return bounds.box();
}

double text_width(const TextParams& params) {
  return Layout(params).width();
}

}  // namespace burin::curves
