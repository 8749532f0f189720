#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <memory>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include <cli/file_io.hpp>
#include <cli/recover/bytes_at.hpp>

namespace burin::cli {

namespace {

constexpr std::size_t window_bytes = std::size_t{256} << 10U;

}  // namespace

BytesAt bytes_of(std::string text) {
  const std::uint64_t size = text.size();
  return {size, [text = std::move(text)](std::uint64_t offset, std::size_t count) {
            return offset >= text.size() ? std::string() : text.substr(static_cast<std::size_t>(offset), count);
          }};
}

Result<BytesAt> bytes_of_file(const std::string& path) {
  // A fifo without a writer must not keep us waiting.
  auto file = std::make_shared<Descriptor>(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  struct stat status {};
  if (!file->is_open() || fstat(file->get(), &status) != 0) {
    return Problem{{path}, "cannot be read: " + system_words(errno)};
  }
  if (S_ISDIR(status.st_mode)) return Problem{{path}, "is a folder, not a file"};
  if (!S_ISREG(status.st_mode)) return Problem{{path}, "is no regular file; give an SVG, PDF or PNG that burin drew"};
  const auto size = static_cast<std::uint64_t>(status.st_size);
  return BytesAt{size, [file, size](std::uint64_t offset, std::size_t count) {
                   if (offset >= size) return std::string();
                   std::string bytes(std::min<std::uint64_t>(count, size - offset), '\0');
                   std::size_t filled = 0;
                   while (filled < bytes.size()) {
                     const ssize_t got = pread(file->get(), bytes.data() + filled, bytes.size() - filled,
                                               static_cast<off_t>(offset + filled));
                     if (got < 0 && errno == EINTR) continue;
                     if (got <= 0) break;
                     filled += static_cast<std::size_t>(got);
                   }
                   bytes.resize(filled);
                   return bytes;
                 }};
}

bool ByteStreamIn::refill() {
  window_ = bytes_.read(next_, window_bytes);
  next_ += window_.size();
  at_ = 0;
  return !window_.empty();
}

bool ByteStreamIn::take_past(std::string_view mark, std::string* kept, std::size_t limit) {
  std::string tail;  // of what was taken: it may hold the beginning of the mark
  const auto keep = [&](std::string_view some) {
    if (kept != nullptr) *kept += some.substr(0, limit - std::min(limit, kept->size()));
  };
  while (!at_end()) {
    const std::string_view rest = std::string_view(window_).substr(at_);
    if (!tail.empty()) {
      const std::string joint = tail + std::string(rest.substr(0, mark.size() - 1));
      if (const std::size_t found = joint.find(mark); found != std::string::npos) {
        keep(std::string_view(joint).substr(0, found));
        at_ += found + mark.size() - tail.size();
        return true;
      }
    }
    if (const std::size_t found = rest.find(mark); found != std::string_view::npos) {
      keep(tail);
      keep(rest.substr(0, found));
      at_ += found + mark.size();
      return true;
    }
    tail += rest;
    const std::size_t certain = tail.size() - std::min(tail.size(), mark.size() - 1);
    keep(std::string_view(tail).substr(0, certain));
    tail.erase(0, certain);
    at_ = window_.size();
  }
  keep(tail);
  return false;
}

}  // namespace burin::cli
