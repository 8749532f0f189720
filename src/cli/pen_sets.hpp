#pragma once

#include <string>
#include <utility>
#include <vector>

#include <burin/base/result.hpp>

namespace burin::cli {

/// Keys of pens and their values: "red.width" and "0.4mm".
using PenKeys = std::vector<std::pair<std::string, std::string>>;

/// What one --pens says: a key of a pen, "red.width=0.4mm", or the name of a set in pens.toml of the user's
/// configuration ($XDG_CONFIG_HOME/burin, else ~/.config/burin), whose pens are all taken. Problems: the file cannot be
/// read or is no TOML, no such set, a set that is no table of tables.
Result<PenKeys> read_pens_option(const std::string& word);

}  // namespace burin::cli
