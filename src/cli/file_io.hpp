#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <burin/base/bytes.hpp>
#include <burin/base/result.hpp>

namespace burin::cli {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  bool is_open() const { return fd_ >= 0; }
  int get() const { return fd_; }
  /// 0, or errno: a full disk on the network may first show here.
  int close();

 private:
  int fd_;
};

/// strerror's words for an errno, in English whatever the locale.
std::string system_words(int error);

/// Writes all of it, whatever signals come; 0 or errno.
int write_all(int fd, std::string_view bytes);

/// Presets are small; data may be ten million points or a photograph.
inline constexpr std::size_t preset_limit_bytes = std::size_t{256} << 10U;
inline constexpr std::size_t data_limit_bytes = std::size_t{256} << 20U;

/// The whole of a file of at most `limit_bytes`; `shown` names it in messages. Pipes may be read, folders not.
Result<std::string> read_file(const std::string& path, const std::string& shown, std::size_t limit_bytes);

/// All of stdin.
Result<std::string> read_stdin(std::size_t limit_bytes);

/// Reads the data files of a preset: names are relative to its folder (empty: the current one), or to the
/// folder of the user's own figures when they begin with primitives::personal_prefix. Regular files only.
ReadFile data_reader(std::string folder);

}  // namespace burin::cli
