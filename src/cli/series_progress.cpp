#include <unistd.h>

#include <fmt/format.h>

#include <cli/file_io.hpp>
#include <cli/progress.hpp>
#include <cli/series_progress.hpp>

namespace burin::cli {

SeriesProgress::SeriesProgress(std::size_t total, bool live)
    : total_(total), live_(live), next_show_(std::chrono::steady_clock::now() + first_show) {}

SeriesProgress::~SeriesProgress() {
  if (shown_) write_all(STDERR_FILENO, erase_line);
}

void SeriesProgress::one_done() {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (!live_ || std::chrono::steady_clock::now() < next_show_) return;
  write_all(STDERR_FILENO, fmt::format("{}{} of {}", erase_line, done_, total_));
  shown_ = true;
  next_show_ = std::chrono::steady_clock::now() + between_shows;
}

}  // namespace burin::cli
