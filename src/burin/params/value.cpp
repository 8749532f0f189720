#include <array>
#include <utility>

#include <burin/params/value.hpp>

namespace burin::params {

const Value* Table::find(std::string_view key) const {
  for (const Entry& entry : entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

Value* Table::find(std::string_view key) {
  return const_cast<Value*>(std::as_const(*this).find(key));
}

void Table::set(std::string key, Value value) {
  if (Value* present = find(key)) {
    *present = std::move(value);
    return;
  }
  const Where where = value.where;
  entries.push_back({std::move(key), where, std::move(value)});
}

std::string_view Value::kind_name() const {
  static constexpr std::array<std::string_view, 6> names{"a boolean", "a whole number", "a number",
                                                         "a text",    "a list",         "a table"};
  return names[data.index()];
}

}  // namespace burin::params
