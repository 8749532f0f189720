#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <burin/base/suggest.hpp>
#include <burin/preset/defines.hpp>

namespace burin::preset {

namespace {

using params::Array;
using params::Entry;
using params::Table;
using params::Value;

constexpr std::size_t longest_chain = 64;
constexpr std::size_t most_values = 100'000;

std::size_t count_values(const Value& value) {
  std::size_t count = 1;
  if (const Array* array = value.array()) {
    for (const Value& item : *array) count += count_values(item);
  } else if (const Table* table = value.table()) {
    for (const Entry& entry : table->entries) count += count_values(entry.value);
  }
  return count;
}

class Resolver {
 public:
  Resolver(Table* defines, Findings& findings) : defines_(defines), findings_(findings) {}

  void resolve(Value& value) {
    if (auto* array = std::get_if<Array>(&value.data)) {
      for (Value& item : *array) resolve(item);
    } else if (auto* table = std::get_if<Table>(&value.data)) {
      for (Entry& entry : table->entries) resolve(entry.value);
      merge(*table, value.where);
    }
  }

  /// The define of this name, itself resolved; null after reporting.
  const Value* resolved_define(const std::string& name, const Where& where) {
    Value* define = defines_ == nullptr ? nullptr : defines_->find(name);
    if (define == nullptr) {
      std::vector<std::string_view> known;
      if (defines_ != nullptr) {
        for (const Entry& entry : defines_->entries) known.push_back(entry.key);
      }
      return refuse(where, fmt::format("no '{}' in [define]{}", name, suggestion(name, known)));
    }
    State& state = states_[name];
    if (state == State::open) return refuse(where, fmt::format("'{}' is like itself; break the circle", name));
    if (state == State::done) return define;
    if (depth_ == longest_chain) {
      return refuse(where, fmt::format("'like' leads through more than {} defines", longest_chain));
    }
    state = State::open;
    ++depth_;
    resolve(*define);
    states_[name] = State::done;
    --depth_;
    return define;
  }

 private:
  enum class State : std::uint8_t { fresh, open, done };

  const Value* refuse(const Where& where, std::string message) {
    findings_.report_and_hush(where, 1, std::move(message));
    return nullptr;
  }

  void merge(Table& table, const Where& where) {
    const Value* like = table.find("like");
    if (like == nullptr) return;
    const Table* below = define_table(*like);
    if (below == nullptr) {
      findings_.hush(where, 1);  // what the define would have said is missing
      drop_like(table);
      return;
    }
    Table merged = *below;
    drop_like(table);
    for (Entry& own : table.entries) {
      if (Value* present = merged.find(own.key)) {
        *present = std::move(own.value);
      } else {
        merged.entries.push_back(std::move(own));
      }
    }
    table = std::move(merged);
  }

  /// The table that `like` names, within the size allowed; null after reporting.
  const Table* define_table(const Value& like) {
    if (like.text() == nullptr) {
      refuse(like.where, fmt::format("'like' names a define in a text, found {}", like.kind_name()));
      return nullptr;
    }
    const Value* define = resolved_define(*like.text(), like.where);
    if (define == nullptr) return nullptr;
    if (define->table() == nullptr) {
      refuse(like.where, fmt::format("'{}' in [define] is {}, not a table", *like.text(), define->kind_name()));
      return nullptr;
    }
    const std::size_t count = count_values(*define);
    if (count > values_left_) {
      values_left_ = 0;
      refuse(like.where, fmt::format("'like' makes the preset grow beyond {} values", most_values));
      return nullptr;
    }
    values_left_ -= count;
    return define->table();
  }

  static void drop_like(Table& table) {
    std::erase_if(table.entries, [](const Entry& entry) { return entry.key == "like"; });
  }

  Table* defines_;
  Findings& findings_;
  std::map<std::string, State> states_;
  std::size_t depth_ = 0;
  std::size_t values_left_ = most_values;
};

}  // namespace

void resolve_likes(Table& root, Findings& findings) {
  Value* section = root.find("define");
  auto* defines = section == nullptr ? nullptr : std::get_if<Table>(&section->data);
  Resolver resolver(defines, findings);
  if (defines != nullptr) {
    for (const Entry& entry : defines->entries) resolver.resolved_define(entry.key, entry.where);
  }
  for (Entry& entry : root.entries) {
    if (entry.key == "define" || entry.key == "knobs") continue;
    auto* named = entry.key == "pens" || entry.key == "slots" ? std::get_if<Table>(&entry.value.data) : nullptr;
    if (named == nullptr) {
      resolver.resolve(entry.value);
    } else {
      // Its keys are names, so even "like" is one.
      for (Entry& each : named->entries) resolver.resolve(each.value);
    }
  }
}

}  // namespace burin::preset
