#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <burin/base/result.hpp>

namespace burin::cli {

/// Seeds as --seed lists them: 7, 0..49, random, random*5, or several of these with commas between.
class SeedList {
 public:
  /// A problem says what is wrong with `text`. Ranges have both their ends and may run down; "random" asks the system.
  static Result<SeedList> read(std::string_view text);

  /// How many, without listing them: a range may hold 2^64.
  double count() const;
  /// All of them in order, doubles too. Pre: as many as memory holds.
  std::vector<std::uint64_t> all() const;

 private:
  struct Range {
    std::uint64_t first = 0;
    std::uint64_t steps = 0;  ///< one less than its seeds
    enum class Way : std::uint8_t { up, down, random } way = Way::up;
  };
  static Result<Range> read_range(std::string_view item);

  std::vector<Range> ranges_;
};

}  // namespace burin::cli
