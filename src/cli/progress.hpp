#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <burin/path/decorators.hpp>

namespace burin::cli {

/// When a line of progress is first shown, how often it changes, and what takes it away.
inline constexpr std::chrono::milliseconds first_show{500};
inline constexpr std::chrono::milliseconds between_shows{100};
inline constexpr std::string_view erase_line = "\r\x1b[K";

/// Passes a drawing on and, from half a second on, shows on stderr how far it is, ten times a second in one line. The
/// line is erased at the end.
class Progress final : public Decorator {
 public:
  /// `expected_points` may be infinite. `live` false: shows nothing.
  Progress(PathSink& next, bool live, std::string what, double expected_points);
  ~Progress() override;

  Flow points(std::span<const Vec2> points) override;
  Vec2* room_for(std::size_t count) override { return next().room_for(count); }

 private:
  void show();

  bool live_;
  std::string what_;
  double expected_points_;
  std::uint64_t points_ = 0;
  std::chrono::steady_clock::time_point next_show_;
  bool shown_ = false;
};

}  // namespace burin::cli
