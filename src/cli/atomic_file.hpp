#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>

#include <burin/base/bytes.hpp>
#include <cli/output_target.hpp>
#include <cli/temporaries.hpp>

namespace burin::cli {

/// An output file that appears whole or not at all: bytes go to a temporary file beside the target, which commit()
/// renames. Without commit() the old file stays as it was. Devices, pipes and stdout are written directly; writing to
/// a pipe that nobody empties ends when `stop` is requested.
class AtomicFile final : public ByteSink {
 public:
  /// `temporaries` must outlive the file.
  static Result<std::unique_ptr<AtomicFile>> open(const std::string& path, Temporaries& temporaries,
                                                  std::stop_token stop);
  ~AtomicFile() override;

  bool write(std::string_view bytes) override;
  std::string failure() const override;

  /// Everything to the disk, then the rename. A problem: any write that failed, now or before.
  Result<Done> commit();

  std::uint64_t byte_count() const { return bytes_; }
  bool is_terminal() const;
  bool failed() const { return error_ != 0; }
  /// The reader of a pipe went away: no news to the user.
  bool lost_reader() const;

 private:
  AtomicFile(std::string shown, OutputTarget target, Temporaries& temporaries, std::stop_token stop)
      : shown_(std::move(shown)), target_(std::move(target)), temporaries_(temporaries), stop_(std::move(stop)) {}

  int open_target();
  int open_special();
  int open_temporary();
  void flush();
  int write_some(std::string_view bytes);
  int replace_target();

  std::string shown_;
  OutputTarget target_;
  Temporaries& temporaries_;
  std::stop_token stop_;
  Descriptor file_;
  std::string temporary_;
  std::string buffer_;
  std::uint64_t bytes_ = 0;
  int error_ = 0;
};

/// A whole file at once, by an AtomicFile.
Result<Done> write_file(const std::string& path, std::string_view bytes, Temporaries& temporaries,
                        const std::stop_token& stop);

}  // namespace burin::cli
