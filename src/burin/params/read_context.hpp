#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <burin/base/bytes.hpp>
#include <burin/base/plane_function.hpp>
#include <burin/base/problem.hpp>
#include <burin/base/result.hpp>
#include <burin/params/value.hpp>

namespace burin::params {

/// A data file that a preset read, so that a drawing can say what it was made from.
struct DataDigest {
  std::string name;
  std::string sha256;
};

/// What {name} stands for in a caption.
struct Placeholder {
  std::string name;
  std::string value;
};

/// What readers of values need besides the value. The preset room fills it in; readers report into `problems` and go
/// on, so that all problems are shown together.
struct ReadContext {
  Problems& problems;

  /// The value of a constant expression such as "sqrt(3)/6".
  std::function<Result<double>(std::string_view text, const Where& where)> evaluate;

  /// The value written under this name in [define], or null.
  std::function<const Value*(std::string_view name)> defined;

  /// Reads a data file named in the preset and notes its digest.
  ReadFile read_file;

  /// Functions that expressions over the place may call besides the built-in ones.
  std::vector<PlaneFunction> functions{};

  /// What captions may quote.
  std::vector<Placeholder> placeholders{};

  /// What is read otherwise than it is written, for people: "d.csv:4: warning: 2 points are dropped".
  std::vector<std::string> warnings{};

  /// How many presets this one is drawn within.
  int nesting = 0;

  /// The same warning is told once.
  void warn(std::string warning) {
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(std::move(warning));
  }

  void report(const Where& where, std::string message) { problems.push_back({where, std::move(message)}); }
};

}  // namespace burin::params
