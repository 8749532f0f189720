#pragma once

#include <cstdint>
#include <optional>

#include <burin/curves/base_shape.hpp>
#include <burin/curves/two_point/block_tables.hpp>
#include <burin/curves/two_point/keyed_rule.hpp>
#include <burin/geom/box2.hpp>

namespace burin::curves::two_point {

/// The box of frame(S_m), exact to rounding, by branch and bound on the reach. Equal sub-edges of one level dominate
/// one another, so that curves with long flat sides cost no more than others. Nothing when the rule does not contract.
std::optional<Box2> bounds(const BaseShape& base, const BlockTables& tables, int levels, const Affine2& frame);
std::optional<Box2> bounds(const BaseShape& base, const KeyedRule& rule, int levels, const Affine2& frame);

}  // namespace burin::curves::two_point
