#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>
#include <burin/preset/load.hpp>

namespace burin::cli {

/// A knob and the values it goes through: turn=0.1..0.9:9 (evenly spaced, with both ends), levels=1..5 (whole numbers),
/// motif=koch,levy,bud, or ranges and values mixed with commas.
class Sweep {
 public:
  /// A problem says what is wrong with `text`, which is all after --sweep.
  static Result<Sweep> read(std::string_view text);

  const std::string& knob() const { return knob_; }
  /// As on the command line: "--sweep levels=1..5".
  const std::string& written() const { return written_; }

  /// How many values, without listing them.
  double count() const;
  /// All of them as -D would take them, in order. Pre: as many as memory holds.
  std::vector<std::string> values() const;

  /// What is wrong with sweeping this preset: no such knob, or fractions for one that takes whole numbers.
  Result<Done> fits(const preset::Summary& summary) const;

 private:
  /// One value, or numbers from `from` to `to`.
  struct Item {
    std::string text;  ///< of one value; of a range: the unit of its numbers
    double from = 0.0;
    double to = 0.0;
    std::uint64_t steps = 0;  ///< one less than its numbers; 0: one value

    std::string value(std::uint64_t index) const;
    bool is_whole() const;
  };
  static Result<Item> read_item(std::string_view text);

  std::string knob_;
  std::string written_;
  std::vector<Item> items_;
};

}  // namespace burin::cli
