#pragma once

#include <memory>
#include <mutex>

#include <burin/base/executor.hpp>

namespace burin::cli {

/// Runs tasks on several cores, through oneTBB. They begin in the order of their numbers. One thread, or one task, is
/// run by the caller, and oneTBB is never started.
class TbbExecutor final : public Executor {
 public:
  /// `threads` 0: as many as this process may use.
  explicit TbbExecutor(int threads);
  ~TbbExecutor() override;

  /// An exception of a task ends the run and reaches the caller.
  void run(std::size_t count, const std::function<void(std::size_t)>& task) const override;
  /// How many tasks may be at work at once.
  std::size_t workers() const;

 private:
  struct Arena;

  int threads_;
  // Kept from the first run with several threads on: threads that just had work are there at once for more.
  mutable std::once_flag started_;
  mutable std::unique_ptr<Arena> arena_;
};

}  // namespace burin::cli
