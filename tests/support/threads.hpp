#pragma once

#include <thread>
#include <vector>

#include <burin/base/executor.hpp>

namespace burin::test {

/// Every task on a thread of its own.
class Threads final : public Executor {
 public:
  void run(std::size_t count, const std::function<void(std::size_t)>& task) const override {
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < count; ++k) threads.emplace_back(task, k);
    for (std::thread& thread : threads) thread.join();
  }
};

}  // namespace burin::test
