#pragma once

#include <burin/base/executor.hpp>

namespace burin::cli {

/// Runs tasks on several cores, through oneTBB. They begin in the order of their numbers. One thread, or one task, is
/// run by the caller, and oneTBB is never started.
class TbbExecutor final : public Executor {
 public:
  /// `threads` 0: as many as this process may use.
  explicit TbbExecutor(int threads) : threads_(threads) {}

  /// An exception of a task ends the run and reaches the caller.
  void run(std::size_t count, const std::function<void(std::size_t)>& task) const override;
  /// How many tasks may be at work at once.
  std::size_t workers() const;

 private:
  int threads_;
};

}  // namespace burin::cli
