#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include <burin/base/executor.hpp>
#include <burin/output/png_picture.hpp>

namespace burin::output {

/// Of compression. On line pages level 4 packs in three quarters of the time, which is a twentieth of all; its files
/// are up to 7 % larger.
inline constexpr int png_level = 6;

/// Writes a PNG of 8 bits a channel in stripes of rows, each packed on its own, through RowDeflater where it is mostly
/// blank, else through libdeflate; so that several workers may pack at a time. Needs 2 MB for each of them, 5 MB
/// for RGB, and what the stripes of one call come to.
class PngStripes {
 public:
  /// `head` must outlive the writer.
  PngStripes(const PngHead& head, WriteBytes write);
  ~PngStripes();

  /// Adds the rows from the first that is still missing up to `end`. Each is read once, in any order and perhaps at the
  /// same time as others. The bytes are the same for every executor; stripes end where the rows of a call do.
  /// `instead`, if any, is tried before, or at the same time: when it is true, nothing is written, and this is false.
  bool add(std::uint32_t end, const ReadRow& read_row, const Executor& executor,
           const std::function<bool()>& instead = {});
  /// After the last row. False: the bytes could not be written.
  bool finish();

  static std::uint32_t rows_per_stripe(const PngHead& head);

 private:
  struct Packer;

  std::unique_ptr<Packer> take_packer();
  void give_back(std::unique_ptr<Packer> packer);
  void write(std::string_view bytes) { good_ = good_ && write_(bytes); }

  const PngHead& head_;
  WriteBytes write_;
  std::uint32_t next_row_ = 0;
  std::uint32_t checksum_;
  bool good_ = true;
  std::mutex packers_mutex_;
  std::vector<std::unique_ptr<Packer>> idle_packers_;
};

}  // namespace burin::output
