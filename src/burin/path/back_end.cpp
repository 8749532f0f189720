#include <fmt/format.h>

#include <burin/path/back_end.hpp>

namespace burin {

Result<Done> check_memory(const BackEnd& back_end, const Forecast& forecast, const Sheet& sheet,
                          const OutputOptions& options, double limit_bytes) {
  const double needed_bytes = back_end.memory_bytes(forecast.points, sheet, options);
  if (needed_bytes <= limit_bytes) return Done{};
  constexpr double bytes_per_mb = 1e6;
  return Problem{
      {},
      fmt::format("writing {} through {} would take about {:.0f} MB of memory, more than {:.0f} MB; draw fewer "
                  "points or pixels, or raise --max-memory",
                  back_end.format, back_end.name, needed_bytes / bytes_per_mb, limit_bytes / bytes_per_mb),
      Trouble::limit,
      {}};
}

}  // namespace burin
