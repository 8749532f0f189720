#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>

namespace burin::cli {

/// Shows on stderr, from half a second on, how many of the results are done: "12 of 50". From any thread.
class SeriesProgress {
 public:
  /// `live` false: shows nothing.
  SeriesProgress(std::size_t total, bool live);
  SeriesProgress(const SeriesProgress&) = delete;
  SeriesProgress& operator=(const SeriesProgress&) = delete;
  /// Erases the line.
  ~SeriesProgress();

  void one_done();

 private:
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::size_t total_;
  bool live_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_show_;
};

}  // namespace burin::cli
