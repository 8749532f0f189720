#pragma once

#include <string>
#include <utility>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/params/read_context.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

/// What a file was drawn from, as its record tells.
struct Recovered {
  std::string version;  ///< of the burin that drew it
  PresetText preset;    ///< without a folder; its source is named after the file
  /// Long names and values of the options of `burin draw` that lead to it again, as if they had been typed.
  std::vector<std::pair<std::string, std::string>> options;
  std::vector<params::DataDigest> data;
};

/// The inverse of origin_record(). A key that this burin does not write is a problem: what it stands for would be lost.
Result<Recovered> read_record(const std::string& record, const std::string& shown);

/// Reads the record in a file that burin drew.
Result<Recovered> recover(const std::string& path);

}  // namespace burin::cli
