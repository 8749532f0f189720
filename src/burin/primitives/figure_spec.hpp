#pragma once

#include <optional>
#include <string>
#include <vector>

#include <burin/params/fields.hpp>
#include <burin/primitives/primitive.hpp>

namespace burin::primitives {

/// The figure that a preset calls `name`: a table of that name in [define] (its keys are figure_fields), SVG path data
/// ("M0 0L1 1"), or what find_primitive finds. Nothing after reporting problems.
std::optional<Primitive> read_figure(const std::string& name, const Where& where, params::ReadContext& context,
                                     double tolerance = figure_tolerance);

/// The figure that a table describes. Nothing after reporting problems.
std::optional<Primitive> read_figure_table(const params::Table& table, const std::string& name, const Where& where,
                                           params::ReadContext& context, double tolerance = figure_tolerance);

/// The keys of a figure written as a table, for help and docs.
std::vector<params::FieldInfo> figure_fields();

}  // namespace burin::primitives
