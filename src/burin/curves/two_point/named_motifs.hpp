#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <burin/curves/two_point/motif.hpp>
#include <burin/geom/vec2.hpp>

namespace burin::curves::two_point {

/// A motif known by name: a row of data. Its shape is a turtle word, or points where edges differ in length.
struct NamedMotif {
  std::string_view name;
  std::string_view alias{};  ///< another name for it, or empty
  std::string_view summary;  ///< one line for lists
  std::string_view source;   ///< who and where
  std::string_view turtle{};
  double angle_degrees = 90.0;           ///< turn of + and -
  std::span<const Vec2> points{};        ///< vertices, y up; empty where `turtle` is not
  std::string_view flip{};               ///< letters of the sub-edges that are mirrored
  std::string_view reverse{};            ///< letters of the sub-edges that are built from their far end
  std::optional<Vec2> join{};            ///< (alpha, beta) of the point of every edge that is drawn
  std::optional<SignRule::Kind> sign{};  ///< instead of flags
  std::string_view dimension_note{};     ///< why the similarity dimension is not the curve's; empty: it is
};

/// All of them, in the order they are listed.
std::span<const NamedMotif> named_motifs();

/// By name or alias; null for unknown names.
const NamedMotif* find_motif(std::string_view name);

/// The named motif as data. Pre: the row is from named_motifs().
Motif motif_from(const NamedMotif& row);
/// The same with another turn of + and -. Pre: the row has a turtle word that does not end where it begins.
Motif motif_from(const NamedMotif& row, double angle_degrees);

/// What a preset would write to get this motif without its name, as an inline table of TOML.
std::string table_text(const NamedMotif& row);

}  // namespace burin::curves::two_point
