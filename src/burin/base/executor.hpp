#pragma once

#include <cstddef>
#include <functional>

namespace burin {

/// Runs independent tasks. Results are stored by index, never by arrival, so the executor cannot change them.
class Executor {
 public:
  virtual ~Executor() = default;

  /// Calls task(0) ... task(count - 1), in any order and perhaps at once; returns when all are done.
  virtual void run(std::size_t count, const std::function<void(std::size_t)>& task) const = 0;
};

/// One after another on the calling thread.
class SerialExecutor final : public Executor {
 public:
  void run(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    for (std::size_t i = 0; i < count; ++i) task(i);
  }
};

}  // namespace burin
