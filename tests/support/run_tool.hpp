#pragma once

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <functional>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace burin::test {

/// How a program ended and what it said.
struct Finished {
  int code = -1;  ///< exit code; 128 + n for a death by signal n; -1 when it had to be killed after the time limit
  std::string out;
  std::string err;
  double cpu_s = 0.0;     ///< user and system time
  double peak_mib = 0.0;  ///< of resident memory; never less than the test had when it started the program
};

/// Where and how a program runs.
struct ToolSetup {
  std::string folder;                                            ///< current folder and home
  std::string input;                                             ///< what stdin gives
  std::vector<std::pair<std::string, std::string>> environment;  ///< on top of the test's own
  std::function<void()> in_child;                                ///< called before exec, with the streams in place
};

/// A program that runs beside the test.
class RunningTool {
 public:
  RunningTool(const std::vector<std::string>& words, const ToolSetup& setup) {
    if (pipe2(out_.data(), O_CLOEXEC) != 0 || pipe2(err_.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe");
    const int input = memfd_create("stdin", MFD_CLOEXEC);
    if (input < 0 || ::write(input, setup.input.data(), setup.input.size()) < 0 || lseek(input, 0, SEEK_SET) != 0) {
      throw std::runtime_error("stdin");
    }
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("fork");
    if (pid_ == 0) become(words, setup, input);
    close(input);
    close(out_[1]);
    close(err_[1]);
  }
  RunningTool(const RunningTool&) = delete;
  RunningTool& operator=(const RunningTool&) = delete;
  ~RunningTool() {
    if (pid_ > 0) wait(std::chrono::seconds(0));
  }

  void send(int signal) const { kill(pid_, signal); }
  /// Nobody reads its stdout any more.
  void close_reader() {
    close(out_[0]);
    out_[0] = -1;
  }

  Finished wait(std::chrono::milliseconds limit = std::chrono::minutes(5)) {
    Finished finished;
    const auto end = std::chrono::steady_clock::now() + limit;
    bool in_time = true;
    std::array<pollfd, 2> streams{pollfd{out_[0], POLLIN, 0}, pollfd{err_[0], POLLIN, 0}};
    while (in_time && (streams[0].fd >= 0 || streams[1].fd >= 0)) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      in_time = left.count() > 0 && poll(streams.data(), streams.size(), static_cast<int>(left.count())) > 0;
      take(streams[0], finished.out);
      take(streams[1], finished.err);
    }
    if (!in_time) kill(pid_, SIGKILL);
    int status = 0;
    rusage used{};
    wait4(pid_, &status, 0, &used);
    pid_ = -1;
    close_all();
    for (const timeval& time : {used.ru_utime, used.ru_stime}) {
      finished.cpu_s += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    finished.peak_mib = static_cast<double>(used.ru_maxrss) / 1024.0;
    if (in_time) finished.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return finished;
  }

 private:
  [[noreturn]] void become(const std::vector<std::string>& words, const ToolSetup& setup, int input) {
    dup2(input, STDIN_FILENO);
    dup2(out_[1], STDOUT_FILENO);
    dup2(err_[1], STDERR_FILENO);
    if (!setup.folder.empty()) {
      if (chdir(setup.folder.c_str()) != 0) _exit(126);
      setenv("HOME", setup.folder.c_str(), 1);
    }
    for (const char* name : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "BURIN_PATH", "NO_COLOR"}) unsetenv(name);
    for (const auto& [name, value] : setup.environment) setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (setup.in_child) setup.in_child();
    execvp(arguments.front(), arguments.data());
    _exit(127);
  }

  static void take(pollfd& stream, std::string& text) {
    if (stream.fd < 0 || stream.revents == 0) return;
    std::array<char, 1 << 16> buffer{};
    const ssize_t got = read(stream.fd, buffer.data(), buffer.size());
    if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
    if (got == 0) stream.fd = -1;
  }

  void close_all() {
    if (out_[0] >= 0) close(out_[0]);
    close(err_[0]);
  }

  std::array<int, 2> out_{-1, -1};
  std::array<int, 2> err_{-1, -1};
  pid_t pid_ = -1;
};

inline Finished run_program(const std::vector<std::string>& words, const ToolSetup& setup) {
  return RunningTool(words, setup).wait();
}

}  // namespace burin::test
