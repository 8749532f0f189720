#include <pthread.h>
#include <unistd.h>
#include <utility>

#include <cli/interrupt.hpp>

namespace burin::cli {

namespace {

constexpr int wake_up = SIGTERM;

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

Interrupt::Interrupt(std::function<void()> at_second) {
  sigemptyset(&watched_);
  sigaddset(&watched_, SIGINT);
  sigaddset(&watched_, SIGTERM);
  sigaddset(&watched_, SIGHUP);
  pthread_sigmask(SIG_BLOCK, &watched_, &before_);
  watcher_ = std::thread([this, call = std::move(at_second)] { watch(call); });
}

Interrupt::~Interrupt() {
  over_ = true;
  pthread_kill(watcher_.native_handle(), wake_up);
  watcher_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupt::watch(const std::function<void()>& at_second) {
  while (true) {
    int received = 0;
    if (sigwait(&watched_, &received) != 0) continue;
    if (over_) return;
    // A blocked signal arrives even when it is ignored.
    if (is_ignored(received)) continue;
    if (signal_ != 0) {
      at_second();
      _exit(128 + signal_);
    }
    signal_ = received;
    stop_.request_stop();
  }
}

}  // namespace burin::cli
