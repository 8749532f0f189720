#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <tuple>

#include <burin/base/problem.hpp>

namespace burin::preset {

/// Everything found wrong with a preset so far. A value whose trouble is known is hushed: what later readers say of it
/// would only repeat the first message in other words.
class Findings {
 public:
  /// Readers report here.
  Problems problems;

  void report(const Where& where, std::string message) { problems.push_back({where, std::move(message)}); }

  /// Reports the trouble of the value at `where`, `length` bytes long in the file, and hushes the value.
  void report_and_hush(const Where& where, std::size_t length, std::string message);

  /// Hushes the value at `where`, `length` bytes long in the file; a command line option is hushed as a whole.
  void hush(const Where& where, std::size_t length);

  bool empty() const { return certain_.empty() && problems.empty(); }

  /// All of them without the hushed ones and repetitions: options first, then `file` as a whole and by position, then
  /// other files. Of more than 500 the rest is only counted.
  Problems sorted(const std::string& file) const;

 private:
  using Place = std::tuple<std::string, int, int>;  ///< file, line, column

  bool is_hushed(const Where& where) const;

  Problems certain_;
  std::map<Place, int> hushed_;  ///< from its first column to the one behind its last
};

}  // namespace burin::preset
