#include <algorithm>
#include <any>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include <burin/path/decorators.hpp>
#include <burin/preset/knobs.hpp>
#include <burin/preset/load.hpp>
#include <burin/preset/nested_piece.hpp>
#include <burin/preset/piece_values.hpp>
#include <burin/preset/plan.hpp>

namespace burin::preset {

namespace {

constexpr int deepest_nesting = 8;

/// A sheet layer of another piece: the parameters of nested_family.
struct NestedLayer {
  std::shared_ptr<const Plan> plan;
  std::size_t layer = 0;

  /// y up, from the lower left corner of its page.
  Affine2 model_from_page() const { return {1.0, 0.0, 0.0, -1.0, 0.0, plan->sheet().page.height_mm}; }

  RunOptions options(const DrawContext& context) const {
    RunOptions options;
    options.tolerance_mm = context.view.tolerance;
    options.stop = context.stop;
    options.executor = context.executor;
    const SheetLayer* wanted = &plan->sheet().layers[layer];
    options.wanted = [wanted](const SheetLayer& each) { return &each == wanted; };
    return options;
  }
};

const NestedLayer& nested(const std::any& parameters) {
  return *std::any_cast<NestedLayer>(&parameters);
}

std::optional<Box2> nested_bounds(const std::any& parameters, const DrawContext& context, const Affine2& frame) {
  constexpr double most_points = 2e7;
  const NestedLayer& layer = nested(parameters);
  const RunOptions options = layer.options(context);
  if (layer.plan->forecast(options, most_points).points > most_points) return std::nullopt;
  BoundsSink bounds;
  Mapped mapped(bounds, frame * layer.model_from_page());
  if (layer.plan->run(mapped, options) == Flow::stop || !bounds.finite()) return std::nullopt;
  return bounds.box();
}

Flow draw_nested(const std::any& parameters, const DrawContext& context, PathSink& sink) {
  const NestedLayer& layer = nested(parameters);
  RunOptions options = layer.options(context);
  const Affine2 model_from_page = translation(-context.origin) * layer.model_from_page();
  if (context.view.is_limited()) options.part_mm = image_box(inverse(model_from_page), context.view.box);
  Mapped mapped(sink, model_from_page);
  Painted painted(mapped, 0, layer.plan->sheet().layers[layer.layer].paint);
  return layer.plan->run(painted, options);
}

/// A family of which presets do not know: its parameters are made here.
const curves::Family& nested_family() {
  static const curves::Family family{
      .name = "piece",
      .summary = "a layer of another preset",
      .source = "",
      .fields = [] { return std::vector<params::FieldInfo>{}; },
      .read = [](const params::Table&, params::ReadContext&,
                 const std::vector<std::string_view>&) -> std::optional<std::any> { return std::nullopt; },
      .bounds = nested_bounds,
      .forecast =
          [](const std::any& parameters, const DrawContext& context, double enough) {
            return nested(parameters).plan->forecast(nested(parameters).options(context), enough);
          },
      .draw = draw_nested,
      .uses_seed = [](const std::any& parameters) { return nested(parameters).plan->uses_seed(); },
      .theory = nullptr,
      .limit_facts = nullptr,
      .retained_every = [](const std::any&) -> std::uint64_t { return 0; },
      .cost_knob = "knobs"};
  return family;
}

std::string folder_of(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? std::string() : file.substr(0, slash + 1);
}

bool read_spec(const params::Value& value, NestedPieceSpec& spec, params::ReadContext& context) {
  if (const std::string* file = value.text()) {
    spec.file = *file;
  } else if (value.table() == nullptr) {
    return params::report_kind(value, "the name of a preset, or { file = \"koch\", knobs = { levels = 3 } }", context);
  } else if (!params::read_fields(*value.table(), spec, "piece", context)) {
    return false;
  }
  if (spec.file.empty()) {
    context.report(value.where, "'file' must name a preset");
    return false;
  }
  if (!spec.file.ends_with(".toml")) spec.file += ".toml";
  return true;
}

/// The knobs as -D would have them.
bool add_knobs(const std::optional<params::Value>& knobs, Overrides& overrides, params::ReadContext& context) {
  if (!knobs) return true;
  if (knobs->table() == nullptr) return params::report_kind(*knobs, "a table { NAME = VALUE }", context);
  for (const params::Entry& entry : knobs->table()->entries) {
    overrides.knobs.emplace_back(entry.key, scalar_text(entry.value));
  }
  return true;
}

std::optional<Plan> plan_of(const NestedPieceSpec& spec, const params::Value& value, params::ReadContext& context) {
  const auto refuse = [&](const std::string& message) {
    context.report(value.where, fmt::format("piece '{}': {}", spec.file, message));
    return std::nullopt;
  };
  if (context.nesting >= deepest_nesting) {
    return refuse(fmt::format("presets within presets go at most {} deep; perhaps one draws itself", deepest_nesting));
  }
  std::string file = spec.file;
  Result<std::string> text = context.read_file(file);
  if (!text && file.find('/') == std::string::npos) {
    Result<std::string> shipped = context.read_file(std::string(library_prefix) + file);
    if (shipped) {
      file = std::string(library_prefix) + file;
      text = std::move(shipped);
    }
  }
  if (!text) return refuse(text.problems().front().message);
  Overrides overrides;
  overrides.nesting = context.nesting + 1;
  if (!add_knobs(spec.knobs, overrides, context)) return std::nullopt;
  if (spec.seed) overrides.seed = static_cast<std::uint64_t>(*spec.seed);
  const ReadFile beside = [read = context.read_file, folder = folder_of(file)](std::string_view name) {
    return read(folder + std::string(name));
  };
  Result<Piece> piece = load({file, *text}, overrides, beside);
  if (!piece) return refuse(problem_text(piece.problems().front()));
  Result<Plan> plan = Plan::make(*std::move(piece));
  if (!plan) return refuse(problem_text(plan.problems().front()));
  return *std::move(plan);
}

bool same_line(const PenSpec& a, const PenSpec& b) {
  return a.color == b.color && a.width == b.width && a.cmyk == b.cmyk && a.spot == b.spot;
}

PenSpec spec_of(const Pen& pen) {
  PenSpec spec{pen.colour, params::Length{pen.width_mm}, std::nullopt, pen.spot};
  if (pen.cmyk)
    spec.cmyk = {100.0 * pen.cmyk->cyan, 100.0 * pen.cmyk->magenta, 100.0 * pen.cmyk->yellow, 100.0 * pen.cmyk->black};
  return spec;
}

/// The name of a pen that draws like this one: the piece's own, or a new one.
std::string pen_for(const Pen& pen, const std::string& stem, const std::vector<NamedPen>& pens,
                    std::vector<NamedPen>& made) {
  const PenSpec spec = spec_of(pen);
  const auto find = [&](const auto& is_wanted) -> const NamedPen* {
    for (const std::vector<NamedPen>* list : {&pens, static_cast<const std::vector<NamedPen>*>(&made)}) {
      const auto found = std::ranges::find_if(*list, is_wanted);
      if (found != list->end()) return &*found;
    }
    return nullptr;
  };
  if (const NamedPen* same = find([&](const NamedPen& each) { return same_line(each.pen, spec); })) return same->name;
  std::string name = pen.name;
  for (int number = 1; find([&](const NamedPen& each) { return each.name == name; }) != nullptr; ++number) {
    name = number == 1 ? fmt::format("{} {}", stem, pen.name) : fmt::format("{} {} {}", stem, pen.name, number);
  }
  made.push_back({name, spec});
  return name;
}

/// The layer with the looks of a sheet layer.
Layer layer_like(const Layer& layer, const SheetLayer& sheet_layer, const std::string& pen) {
  Layer like = layer;
  like.style.pen.of = {pen};
  like.style.caps = sheet_layer.cap;
  like.style.joins = sheet_layer.join;
  like.style.miter = sheet_layer.miter_limit;
  like.style.opacity *= sheet_layer.opacity;
  like.style.dashes.clear();
  for (const double dash_mm : sheet_layer.dashes_mm) like.style.dashes.push_back({dash_mm});
  if (sheet_layer.paint != Paint::stroke) {
    like.style.fill = pen;
    like.style.rule = sheet_layer.paint == Paint::fill_evenodd ? FillRule::evenodd : FillRule::nonzero;
    like.style.stroke = "none";
  }
  return like;
}

}  // namespace

std::optional<NestedLayers> read_nested_piece(const params::Value& value, const Layer& layer, bool keeps_pen,
                                              const std::vector<NamedPen>& pens, params::ReadContext& context) {
  NestedPieceSpec spec;
  if (!read_spec(value, spec, context)) return std::nullopt;
  std::optional<Plan> plan = plan_of(spec, value, context);
  if (!plan) return std::nullopt;
  const auto shared = std::make_shared<const Plan>(*std::move(plan));
  const Sheet& sheet = shared->sheet();
  const std::string stem =
      spec.file.substr(folder_of(spec.file).size(), spec.file.rfind('.') - folder_of(spec.file).size());
  NestedLayers nested_layers;
  for (std::size_t i = 0; i < sheet.layers.size(); ++i) {
    const SheetLayer& sheet_layer = sheet.layers[i];
    const std::string pen =
        keeps_pen ? layer.style.pen.of.front() : pen_for(sheet.pens[sheet_layer.pen], stem, pens, nested_layers.pens);
    nested_layers.layers.push_back(layer_like(layer, sheet_layer, pen));
    nested_layers.layers.back().family = &nested_family();
    nested_layers.layers.back().parameters = NestedLayer{shared, i};
  }
  return nested_layers;
}

}  // namespace burin::preset
