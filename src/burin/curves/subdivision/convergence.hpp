#pragma once

#include <optional>
#include <string>
#include <vector>

#include <burin/curves/limit_facts.hpp>

/// How smooth the limit of a subdivision scheme is, from its mask. A mask a_0 .. a_s says P'_k = sum_j a_{k-2j} P_j, up
/// to a shift of k.
namespace burin::curves::subdivision {

/// Norms of the powers 1 .. steps of the scheme with this mask: the most that a value can grow.
std::vector<double> norms_of_powers(const std::vector<double>& mask, int steps);

/// A lower bound of the joint spectral radius of the two maps between neighbouring values: the greatest mean growth
/// rho(A_w)^(1/|w|) over words w of at most `longest` halvings. Exponential in `longest`.
double spectral_radius_bound(const std::vector<double>& mask, int longest);

/// What is proven of the limit as a function of its parameter. C-1: not even continuous.
struct Convergence {
  int sum_rules = 0;            ///< how often 1 + z divides the mask
  int proven = -1;              ///< the limit is C^proven for all data; -1: nothing proven
  int steps = 0;                ///< the power of the difference scheme that proves it
  std::optional<int> excluded;  ///< the limit is not C^excluded for all data; 0: the scheme diverges
  double exponent_low = 0.0;    ///< Hoelder exponent: at least this
  double exponent_high = 0.0;   ///< and at most this

  Smoothness smoothness() const { return {proven, excluded, exponent_low, exponent_high}; }
};

/// Divides the mask by 1 + z as often as it can, which gives the difference schemes, and holds the norms of their
/// powers up to 12 and the spectral radii of words up to 10 against 1. About 10 ms. Source: reference curves E; Dyn
/// 1992. Pre: even and odd weights have the sum 1 each.
Convergence classify(const std::vector<double>& mask);

/// The same in words, a few lines.
std::string convergence_text(const Convergence& convergence);

}  // namespace burin::curves::subdivision
