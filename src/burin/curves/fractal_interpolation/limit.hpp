#pragma once

#include <string>

#include <burin/curves/fractal_interpolation/curve.hpp>
#include <burin/curves/limit_facts.hpp>

/// What is known of the curve that the level sets fill. Source: reference interpolation 4, 6, 7.
namespace burin::curves::fractal_interpolation {

/// phi is C1 where every scaling stays below its interval's share of the whole, else of the Hoelder exponent
/// min log S_i / log a_i; a graph of dimension D > 1 has none above 2 - D. Needs the dimension for the latter.
Smoothness smoothness_of(const Interpolant& f, const FractalDimension& dimension);

/// Of all blocks together. Nothing for a part of a curve, and for plots of something else than the curve.
LimitFacts limit_facts(const Curve& curve);

/// The same in words, a few lines.
std::string theory_text(const Curve& curve);

}  // namespace burin::curves::fractal_interpolation
