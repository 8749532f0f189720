#include <cerrno>
#include <chrono>
#include <climits>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include <cli/atomic_file.hpp>

namespace burin::cli {

namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 16U;
/// How long a stop may go unheard while a pipe is full or has no reader.
constexpr int patience_ms = 50;

std::string folder_of(const std::string& path) {
  return std::filesystem::path(path).parent_path().string();
}

/// Makes the new name itself survive a crash; some file systems cannot, and the data is safe without.
void sync_folder(const std::string& folder) {
  const Descriptor handle(open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (handle.is_open()) fsync(handle.get());
}

}  // namespace

Result<std::unique_ptr<AtomicFile>> AtomicFile::open(const std::string& path, Temporaries& temporaries,
                                                     std::stop_token stop) {
  Result<OutputTarget> target = output_target(path);
  if (!target) return target.problems();
  std::unique_ptr<AtomicFile> file(new AtomicFile(path, *std::move(target), temporaries, std::move(stop)));
  if (const int error = file->open_target(); error != 0) return write_problem(path, error);
  return file;
}

AtomicFile::~AtomicFile() {
  if (temporary_.empty()) return;
  unlink(temporary_.c_str());
  temporaries_.forget(temporary_);
}

int AtomicFile::open_target() {
  switch (target_.kind) {
    case OutputTarget::Kind::descriptor:
      file_ = Descriptor(fcntl(target_.descriptor, F_DUPFD_CLOEXEC, 3));
      return file_.is_open() ? 0 : errno;
    case OutputTarget::Kind::special:
      return open_special();
    case OutputTarget::Kind::file:
      break;
  }
  return open_temporary();
}

int AtomicFile::open_special() {
  while (!stop_.stop_requested()) {
    file_ = Descriptor(::open(target_.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
    if (file_.is_open()) return fcntl(file_.get(), F_SETFL, 0) == 0 ? 0 : errno;
    if (errno != ENXIO) return errno;  // ENXIO: a fifo waits for its reader
    std::this_thread::sleep_for(std::chrono::milliseconds(patience_ms));
  }
  return EINTR;
}

int AtomicFile::open_temporary() {
  const std::string folder = folder_of(target_.path);
  sweep_temporaries(folder);
  TemporaryFile made = make_temporary(folder);
  if (!made.file.is_open()) return made.error;
  file_ = std::move(made.file);
  temporary_ = std::move(made.path);
  temporaries_.add(temporary_);
  if (const auto& old = target_.replaces) {
    // Only root can give a file away; everyone else keeps what they make.
    if (fchown(file_.get(), old->user, old->group) != 0) errno = 0;
    if (fchmod(file_.get(), old->mode) != 0) return errno;
  }
  return 0;
}

bool AtomicFile::write(std::string_view bytes) {
  if (error_ != 0) return false;
  bytes_ += bytes.size();
  buffer_ += bytes;
  if (buffer_.size() >= buffer_bytes) flush();
  return error_ == 0;
}

void AtomicFile::flush() {
  if (error_ != 0) return;
  std::string_view rest(buffer_);
  if (target_.kind == OutputTarget::Kind::file) {
    error_ = write_all(file_.get(), rest);
  } else {
    while (!rest.empty() && error_ == 0) {
      const std::string_view piece = rest.substr(0, PIPE_BUF);
      error_ = write_some(piece);
      rest.remove_prefix(piece.size());
    }
  }
  buffer_.clear();
}

/// A piece that a ready pipe takes without blocking.
int AtomicFile::write_some(std::string_view bytes) {
  pollfd ready{file_.get(), POLLOUT, 0};
  while (poll(&ready, 1, patience_ms) == 0) {
    if (stop_.stop_requested()) return EINTR;
  }
  return write_all(file_.get(), bytes);
}

std::string AtomicFile::failure() const {
  return error_ == 0 ? std::string() : system_words(error_);
}

bool AtomicFile::is_terminal() const {
  return isatty(file_.get()) == 1;
}

bool AtomicFile::lost_reader() const {
  return error_ == EPIPE;
}

Result<Done> AtomicFile::commit() {
  flush();
  if (error_ == 0 && target_.kind == OutputTarget::Kind::file) error_ = replace_target();
  if (error_ != 0) return write_problem(shown_, error_);
  return Done{};
}

int AtomicFile::replace_target() {
  if (fsync(file_.get()) != 0 && errno != EINVAL && errno != ENOTSUP) return errno;
  if (const int error = file_.close(); error != 0) return error;
  if (rename(temporary_.c_str(), target_.path.c_str()) != 0) return errno;
  temporaries_.forget(temporary_);
  temporary_.clear();
  sync_folder(folder_of(target_.path));
  return 0;
}

Result<Done> write_file(const std::string& path, std::string_view bytes, Temporaries& temporaries,
                        const std::stop_token& stop) {
  const Result<std::unique_ptr<AtomicFile>> file = AtomicFile::open(path, temporaries, stop);
  if (!file) return file.problems();
  static_cast<void>((*file)->write(bytes));  // commit() tells what failed
  return (*file)->commit();
}

}  // namespace burin::cli
