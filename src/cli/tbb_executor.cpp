#include <algorithm>
#include <atomic>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cli/tbb_executor.hpp>

namespace burin::cli {

void TbbExecutor::run(std::size_t count, const std::function<void(std::size_t)>& task) const {
  const auto wanted = static_cast<std::size_t>(threads_ > 0 ? threads_ : tbb::info::default_concurrency());
  const std::size_t workers = std::min(wanted, count);
  if (workers <= 1) return SerialExecutor().run(count, task);
  // oneTBB starts no more threads than there are cores unless it is told to.
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, workers);
  tbb::task_arena arena(static_cast<int>(workers));
  std::atomic<std::size_t> next = 0;
  // oneTBB itself orders what is done before, in and after the loop. The thread sanitizer does not see into it, but
  // into these.
  std::atomic<std::size_t> ended = 0;
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, workers, [&](std::size_t) {
      for (std::size_t i = next++; i < count; i = next++) task(i);
      ended.fetch_add(1, std::memory_order_release);
    });
  });
  static_cast<void>(ended.load(std::memory_order_acquire));
}

}  // namespace burin::cli
