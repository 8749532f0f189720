#include <cstddef>
#include <cstdint>

#include <burin/base/check.hpp>
#include <burin/data/svg_path.hpp>

/// Any bytes as path data: a result has finite points only, a problem an offset inside the data.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view d(reinterpret_cast<const char*>(bytes), size);
  const auto parsed = burin::data::parse_svg_path(d, 0.1, {"d", 1, 1});
  if (!parsed) {
    const int column = parsed.problems().front().where.column;
    BURIN_EXPECT(column >= 1 && static_cast<std::size_t>(column) <= size + 1);
    return 0;
  }
  for (const burin::data::Subpath& subpath : *parsed) {
    BURIN_EXPECT(!subpath.points.empty());
    for (const burin::Vec2 p : subpath.points) BURIN_EXPECT(burin::is_finite(p));
  }
  return 0;
}
