#pragma once

#include <any>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <burin/curves/limit_facts.hpp>
#include <burin/params/fields.hpp>
#include <burin/path/draw_context.hpp>
#include <burin/path/path_sink.hpp>

namespace burin::curves {

/// A 2D generator: a row of the catalogue. Parameters travel type-erased; a family's functions get back exactly what
/// its `read` made. All functions are pure: the same (parameters, seed) give the same points.
struct Family {
  std::string_view name;
  std::string_view summary;
  std::string_view source;  ///< paper and equation
  std::vector<params::FieldInfo> (*fields)();

  /// Reads the keys of a curve's table but for those in `also_known`; nothing after reporting problems.
  std::optional<std::any> (*read)(const params::Table& table, params::ReadContext& context,
                                  const std::vector<std::string_view>& also_known);

  /// The box of frame(curve), exact to rounding. Nothing when it cannot be had: too many points to run through without
  /// a bound on what an edge generates, or points beyond the range of numbers.
  std::optional<Box2> (*bounds)(const std::any& parameters, const DrawContext& context, const Affine2& frame);

  /// What draw will emit under this context. Gives up counting above `enough` points and then reports a bound above it.
  Forecast (*forecast)(const std::any& parameters, const DrawContext& context, double enough);

  /// Emits the curve in model units, y up, with layer 0.
  Flow (*draw)(const std::any& parameters, const DrawContext& context, PathSink& sink);

  /// Whether another seed gives another curve.
  bool (*uses_seed)(const std::any& parameters);

  /// What is known of the limit for these parameters, line by line, for "burin show"; null: nothing.
  std::string (*theory)(const std::any& parameters);

  /// The same and more for programs; null: nothing.
  LimitFacts (*limit_facts)(const std::any& parameters);

  /// Which points of each path the level before had already: those whose index, from 0, is a multiple of this. 0: none.
  std::uint64_t (*retained_every)(const std::any& parameters);

  /// The parameter to lower when a curve has too many points, for messages: "levels".
  std::string_view cost_knob;
};

/// All families, in the order they are listed.
std::span<const Family> catalogue();

/// The family of this name, or null.
const Family* find_family(std::string_view name);

/// The family that a curve's table names by 'family'; null after reporting.
const Family* read_family(const params::Table& table, const Where& where, params::ReadContext& context);

/// A row for the catalogue from a struct F that holds a family's functions: `using Params`, and static check
/// (cross-field rules; false after reporting), bounds, forecast, draw and uses_seed, all for Params instead of
/// std::any; theory and limit_facts, if there is any, and retained_every, where a level keeps the points of the one
/// before.
template <class F>
Family make_family(std::string_view name, std::string_view summary, std::string_view source,
                   std::string_view cost_knob) {
  using P = typename F::Params;
  static_assert(params::ParamStruct<P>, "every member of the parameters needs a row in fields()");
  std::string (*theory)(const std::any&) = nullptr;
  if constexpr (requires(const P& p) { F::theory(p); }) {
    theory = [](const std::any& p) { return F::theory(*std::any_cast<P>(&p)); };
  }
  LimitFacts (*limit_facts)(const std::any&) = nullptr;
  if constexpr (requires(const P& p) { F::limit_facts(p); }) {
    limit_facts = [](const std::any& p) { return F::limit_facts(*std::any_cast<P>(&p)); };
  }
  return {
      .name = name,
      .summary = summary,
      .source = source,
      .fields = &params::field_infos<P>,
      .read = [](const params::Table& table, params::ReadContext& context,
                 const std::vector<std::string_view>& also_known) -> std::optional<std::any> {
        P read{};
        if (!params::read_fields(table, read, "curve", context, also_known)) return std::nullopt;
        if (!F::check(read, table, context)) return std::nullopt;
        return std::any(std::move(read));
      },
      .bounds = [](const std::any& p, const DrawContext& context,
                   const Affine2& frame) { return F::bounds(*std::any_cast<P>(&p), context, frame); },
      .forecast = [](const std::any& p, const DrawContext& context,
                     double enough) { return F::forecast(*std::any_cast<P>(&p), context, enough); },
      .draw = [](const std::any& p, const DrawContext& context,
                 PathSink& sink) { return F::draw(*std::any_cast<P>(&p), context, sink); },
      .uses_seed = [](const std::any& p) { return F::uses_seed(*std::any_cast<P>(&p)); },
      .theory = theory,
      .limit_facts = limit_facts,
      .retained_every = [](const std::any& p) -> std::uint64_t {
        if constexpr (requires(const P& params) { F::retained_every(params); }) {
          return F::retained_every(*std::any_cast<P>(&p));
        } else {
          return 0;
        }
      },
      .cost_knob = cost_knob,
  };
}

}  // namespace burin::curves
