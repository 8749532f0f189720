#include <any>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include <burin/curves/curve_source.hpp>
#include <burin/curves/family.hpp>
#include <burin/path/recording.hpp>

namespace burin::params {

using curves::CurveSource;

bool ValueType<CurveSource>::read(const Value& value, CurveSource& source, ReadContext& context) {
  const Table* table = value.table();
  if (table == nullptr) return report_kind(value, "a curve: { family = \"two-point\", levels = 3 }", context);
  const curves::Family* family = curves::read_family(*table, value.where, context);
  if (family == nullptr) return false;
  std::int64_t seed = 0;
  if (const Value* number = table->find("seed"); number != nullptr) {
    if (!ValueType<std::int64_t>::read(*number, seed, context)) return false;
  }
  const std::optional<std::any> parameters = family->read(*table, context, {"family", "seed"});
  if (!parameters) return false;

  const DrawContext of_curve{.seed = static_cast<std::uint64_t>(seed)};
  if (family->forecast(*parameters, of_curve, curves::most_source_points).points > curves::most_source_points) {
    context.report(value.where,
                   fmt::format("a base takes at most a million points of a curve; lower '{}'", family->cost_knob));
    return false;
  }
  Recorder recorder;
  static_cast<void>(family->draw(*parameters, of_curve, recorder));
  const Recording drawn = recorder.take();
  for (const Recording::Path& path : drawn.paths()) {
    for (const Recording::Contour& contour : drawn.contours(path)) {
      const std::span<const Vec2> points = drawn.points(contour);
      source.polylines.push_back({{points.begin(), points.end()}, path.head.closed});
    }
  }
  return true;
}

}  // namespace burin::params
