#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <burin/params/value.hpp>
#include <burin/preset/findings.hpp>

/// Presets are TOML 1.0. This is the only place that knows it; toml.cpp is the only file that names toml++.
namespace burin::preset {

inline constexpr std::size_t longest_preset_bytes = std::size_t{256} * 1024;

/// A byte order mark at the beginning of a text is no part of it.
std::string_view without_byte_order_mark(std::string_view text);

/// The tree of a preset's text, entries in the order of the file; nothing after a syntax error, which ends reading.
/// Dates, nan and inf are reported, and reading goes on. `most_bytes`: texts above are refused.
std::optional<params::Table> parse_toml(std::string_view text, const std::string& file, Findings& findings,
                                        std::size_t most_bytes = longest_preset_bytes);

/// What `text` is as the value of a key, all of it at `where`; nothing when it is no TOML value.
std::optional<params::Value> parse_toml_value(std::string_view text, const Where& where, Findings& findings);

}  // namespace burin::preset
