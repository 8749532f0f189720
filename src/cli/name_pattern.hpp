#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <burin/base/result.hpp>

namespace burin::cli {

/// What stands for a placeholder: its name and the text that is put in.
using NameValues = std::vector<std::pair<std::string, std::string>>;

/// The path of an output with placeholders in braces: "out/{preset}-{seed}.svg". "{{" and "}}" are braces.
class NamePattern {
 public:
  /// A problem: an unmatched brace.
  static Result<NamePattern> read(std::string_view path);
  /// "{preset}.svg"
  static NamePattern of_preset(std::string_view suffix);

  bool has_placeholders() const;
  bool has(std::string_view name) const;
  /// What is wrong with the names in it: those that are not among `known`.
  Result<Done> check(const std::vector<std::string_view>& known) const;

  /// Puts "-{name}" before the suffix.
  void add(std::string_view name);

  /// Pre: `values` has every name in it.
  std::string fill(const NameValues& values) const;
  /// As it is written.
  std::string text() const;

 private:
  struct Part {
    std::string text;
    bool is_name = false;
  };
  std::vector<Part> parts_;
};

/// A value as part of a file name: no separators, control or shell characters, not empty, not dots alone, at most 100
/// bytes.
std::string name_safe(std::string_view value);

}  // namespace burin::cli
