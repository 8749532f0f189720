#include <map>
#include <set>

#include <fmt/format.h>

#include <burin/preset/layer_names.hpp>
#include <burin/preset/layer_source.hpp>

namespace burin::preset {

namespace {

using params::Array;
using params::Table;
using params::Value;

/// "layer" when the source does not tell.
std::string implied_name(const Value& layer) {
  const Table* table = layer.table();
  const Value* curve = table == nullptr ? nullptr : table->find("curve");
  if (curve == nullptr) {
    for (const std::string_view source : source_keys()) {
      if (table != nullptr && table->find(source) != nullptr) return std::string(source);
    }
    return "layer";
  }
  if (curve->text() != nullptr) return *curve->text();
  for (const char* key : {"like", "family"}) {
    if (const std::string* name = text_at(curve->table(), key)) return *name;
  }
  return "layer";
}

}  // namespace

const std::string* text_at(const Table* table, std::string_view key) {
  const Value* value = table == nullptr ? nullptr : table->find(key);
  return value == nullptr ? nullptr : value->text();
}

std::vector<std::string> layer_names(const Array& layers) {
  std::set<std::string> taken;
  std::map<std::string, int> last_numbers;
  std::vector<std::string> names;
  for (const Value& layer : layers) {
    const std::string* name = text_at(layer.table(), "name");
    names.push_back(name == nullptr ? std::string{} : *name);
    if (name != nullptr) taken.insert(*name);
  }
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!names[i].empty()) continue;
    const std::string base = implied_name(layers[i]);
    names[i] = base;
    int& number = last_numbers[base];
    while (!taken.insert(names[i]).second) names[i] = fmt::format("{} {}", base, ++number + 1);
  }
  return names;
}

void check_layer_names(const Array& layers, params::ReadContext& context) {
  std::set<std::string> seen;
  for (const Value& layer : layers) {
    const std::string* name = text_at(layer.table(), "name");
    if (name == nullptr || name->empty() || seen.insert(*name).second) continue;
    context.report(layer.table()->find("name")->where,
                   fmt::format("two layers are called '{}'; give each a name of its own", *name));
  }
}

}  // namespace burin::preset
