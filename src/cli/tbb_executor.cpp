#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <thread>
#include <vector>

#include <cli/tbb_executor.hpp>

namespace burin::cli {

#ifdef __SANITIZE_THREAD__

/// oneTBB is not built for the thread sanitizer, which sees races in every hand-over: here threads do without it.
struct TbbExecutor::Arena {
  explicit Arena(int) {}

  template <class Worker>
  static void run(std::size_t workers, const Worker& worker) {
    std::vector<std::exception_ptr> thrown(workers);
    {
      std::vector<std::jthread> threads;
      for (std::exception_ptr& mine : thrown) {
        threads.emplace_back([&worker, &mine] {
          try {
            worker();
          } catch (...) {
            mine = std::current_exception();
          }
        });
      }
    }
    for (const std::exception_ptr& each : thrown) {
      if (each) std::rethrow_exception(each);
    }
  }
};

#else

/// A thread that sleeps takes as long to wake as a short run does. So long it stays awake for another one.
constexpr std::chrono::microseconds stays_awake{200};

struct TbbExecutor::Arena {
  explicit Arena(int threads)
      : more(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)), arena(threads) {}
  ~Arena() { ++*runs; }
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;

  /// Calls worker() `workers` times, at the same time.
  template <class Worker>
  void run(std::size_t workers, const Worker& worker) {
    ++*runs;
    arena.execute([&] {
      tbb::parallel_for(
          std::size_t{0}, workers, [&](std::size_t) { worker(); }, tbb::simple_partitioner());
    });
    for (std::size_t k = 1; k < workers; ++k) {
      arena.enqueue([all_runs = runs, run = runs->load()] {
        const auto end = std::chrono::steady_clock::now() + stays_awake;
        while (*all_runs == run && std::chrono::steady_clock::now() < end) std::this_thread::yield();
      });
    }
  }

  tbb::global_control more;  ///< oneTBB starts no more threads than there are cores unless it is told to
  tbb::task_arena arena;
  /// How many there were: shared with threads that wait for the next.
  std::shared_ptr<std::atomic<std::size_t>> runs = std::make_shared<std::atomic<std::size_t>>(0);
};

#endif

TbbExecutor::TbbExecutor(int threads) : threads_(threads) {}

TbbExecutor::~TbbExecutor() = default;

std::size_t TbbExecutor::workers() const {
  return static_cast<std::size_t>(threads_ > 0 ? threads_ : tbb::info::default_concurrency());
}

void TbbExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task) const {
  const std::size_t threads = std::min(workers(), count);
  if (threads <= 1) return SerialExecutor().run(count, task);
  std::atomic<std::size_t> next = 0;
  std::call_once(started_, [this] { arena_ = std::make_unique<Arena>(static_cast<int>(workers())); });
  arena_->run(threads, [&] {
    for (std::size_t i = next++; i < count; i = next++) task(i);
  });
}

}  // namespace burin::cli
