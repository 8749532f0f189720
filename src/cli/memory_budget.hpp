#pragma once

#include <condition_variable>
#include <mutex>

namespace burin::cli {

/// Keeps drawings that go on at once within one limit of memory: who would pass it waits until others are done.
class MemoryBudget {
 public:
  explicit MemoryBudget(double limit_bytes) : limit_bytes_(limit_bytes) {}

  /// What one drawing holds, until it ends.
  class Share {
   public:
    /// Waits until there is room. One that is larger than the limit by itself waits to be alone. Without a budget there
    /// is always room.
    Share(MemoryBudget* budget, double bytes) : budget_(budget), bytes_(bytes) {
      if (budget_ == nullptr) return;
      std::unique_lock lock(budget_->mutex_);
      budget_->freed_.wait(lock,
                           [&] { return budget_->held_ == 0 || budget_->used_ + bytes_ <= budget_->limit_bytes_; });
      ++budget_->held_;
      budget_->used_ += bytes_;
    }
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;
    ~Share() {
      if (budget_ == nullptr) return;
      {
        const std::lock_guard lock(budget_->mutex_);
        --budget_->held_;
        budget_->used_ -= bytes_;
      }
      budget_->freed_.notify_all();
    }

   private:
    MemoryBudget* budget_;
    double bytes_;
  };

 private:
  std::mutex mutex_;
  std::condition_variable freed_;
  double limit_bytes_;
  double used_ = 0.0;
  int held_ = 0;
};

}  // namespace burin::cli
