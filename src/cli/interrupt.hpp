#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <stop_token>
#include <thread>

#include <cli/exit_code.hpp>

namespace burin::cli {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP (its terminal was closed) requests a stop; the second one calls
/// `at_second` and ends the process at once. Signals that were ignored when the tool began stay ignored. The signals
/// are blocked in every thread and taken by a thread of its own, so nothing has to be async-signal-safe. Make it before
/// other threads; one at a time.
class Interrupt {
 public:
  explicit Interrupt(std::function<void()> at_second);
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  ~Interrupt();

  std::stop_token stop() const { return stop_.get_token(); }
  /// The signal that came, or 0.
  int signal() const { return signal_; }
  /// How a tool ends that was stopped. Pre: a signal came.
  ExitCode exit_code() const { return static_cast<ExitCode>(128 + signal_); }

 private:
  void watch(const std::function<void()>& at_second);

  sigset_t watched_{};
  sigset_t before_{};
  std::stop_source stop_;
  std::atomic<int> signal_ = 0;
  std::atomic<bool> over_ = false;
  std::thread watcher_;
};

}  // namespace burin::cli
