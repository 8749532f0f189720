#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <burin/base/problem.hpp>

namespace burin::params {

struct Value;
struct Entry;

using Array = std::vector<Value>;

/// Keys and values in the order of the file. Keys are distinct.
struct Table {
  std::vector<Entry> entries;

  const Value* find(std::string_view key) const;
  Value* find(std::string_view key);
  /// Replaces the value of `key`, or appends a new entry.
  void set(std::string key, Value value);
};

/// What a preset says at one place: a tree that no longer knows which format it came from.
struct Value {
  Where where;
  std::variant<bool, std::int64_t, double, std::string, Array, Table> data;

  const Table* table() const { return std::get_if<Table>(&data); }
  const Array* array() const { return std::get_if<Array>(&data); }
  const std::string* text() const { return std::get_if<std::string>(&data); }
  /// "a table", "a number" ...: for messages.
  std::string_view kind_name() const;
};

struct Entry {
  std::string key;
  Where where;  ///< of the key
  Value value;
};

}  // namespace burin::params
