#include <unistd.h>
#include <utility>

#include <fmt/format.h>

#include <cli/file_io.hpp>
#include <cli/progress.hpp>

namespace burin::cli {

Progress::Progress(PathSink& next, bool live, std::string what, double expected_points)
    : Decorator(next),
      live_(live),
      what_(std::move(what)),
      expected_points_(expected_points),
      next_show_(std::chrono::steady_clock::now() + first_show) {}

Progress::~Progress() {
  if (shown_) write_all(STDERR_FILENO, erase_line);
}

Flow Progress::points(std::span<const Vec2> points) {
  points_ += points.size();
  if (live_ && std::chrono::steady_clock::now() >= next_show_) show();
  return next().points(points);
}

void Progress::show() {
  const double done = static_cast<double>(points_);
  std::string line = fmt::format("{}{}: {:.1f} million points", erase_line, what_, done / 1e6);
  if (expected_points_ >= done && expected_points_ < 1e15) {
    line += fmt::format(", {:.0f} %", 100.0 * done / expected_points_);
  }
  write_all(STDERR_FILENO, line);
  shown_ = true;
  next_show_ = std::chrono::steady_clock::now() + between_shows;
}

}  // namespace burin::cli
