#include <algorithm>
#include <atomic>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <burin/output/deflate.hpp>
#include <burin/output/png_stripes.hpp>
#include <burin/output/row_deflater.hpp>

namespace burin::output {

namespace {

/// So much is compressed at a time. The less, the more repetitions of what came before are lost. Line pages become 0.5
/// % larger by it; of RGB, whose rows are longer, as much at a time would cost 3 %.
std::size_t stripe_bytes(PngPixels pixels) {
  return std::size_t{1} << (pixels == PngPixels::rgb ? 21U : 19U);
}

/// A stripe of so few tokens of RowDeflater is about as small by it as by a search for all repetitions. Wide stripes
/// of few rows have more to repeat along a row than from the row above: with four times as many, a dragon is twice as
/// large at 20,000 pixels.
constexpr std::size_t most_tokens = 1024;

/// Some rows of the page: their piece of the zlib stream in a chunk of its own.
struct Stripe {
  std::string chunk;
  std::size_t bytes = 0;
  std::uint32_t checksum = 1;
};

/// Nothing: the stripe is not blank enough for it.
std::optional<std::string> in_rows(std::string_view bytes, std::size_t row_bytes) {
  RowDeflater deflate(row_bytes);
  for (; !bytes.empty(); bytes.remove_prefix(row_bytes)) {
    deflate.add(reinterpret_cast<const std::uint8_t*>(bytes.data()));
    if (deflate.tokens() > most_tokens) return std::nullopt;
  }
  return deflate.piece();
}

}  // namespace

/// What a worker needs for one stripe after the other: memory that is new costs more than to fill it.
struct PngStripes::Packer {
  Deflater deflate{png_level};
  std::string bytes;

  Stripe stripe(const PngHead& head, std::uint32_t top, std::uint32_t end, const ReadRow& read_row);
};

Stripe PngStripes::Packer::stripe(const PngHead& head, std::uint32_t top, std::uint32_t end, const ReadRow& read_row) {
  const std::size_t row_bytes = 1 + head.bytes_per_row();
  bytes.resize(row_bytes * (end - top));
  for (std::uint32_t j = top; j < end; ++j) {
    char* const row = bytes.data() + (j - top) * row_bytes;
    row[0] = 0;  // no filter
    read_row(j, reinterpret_cast<std::uint8_t*>(row) + 1);
  }
  std::string piece(top == 0 ? zlib_start : "");
  if (const std::optional<std::string> rows = in_rows(bytes, row_bytes)) {
    piece += *rows;
  } else {
    piece += deflate.piece(bytes);
  }
  return {chunk_bytes({"IDAT", std::move(piece)}), bytes.size(), adler32_of(bytes)};
}

PngStripes::PngStripes(const PngHead& head, WriteBytes write)
    : head_(head), write_(std::move(write)), checksum_(adler32_of({})) {}

PngStripes::~PngStripes() = default;

std::unique_ptr<PngStripes::Packer> PngStripes::take_packer() {
  const std::lock_guard lock(packers_mutex_);
  if (idle_packers_.empty()) return std::make_unique<Packer>();
  std::unique_ptr<Packer> packer = std::move(idle_packers_.back());
  idle_packers_.pop_back();
  return packer;
}

void PngStripes::give_back(std::unique_ptr<Packer> packer) {
  const std::lock_guard lock(packers_mutex_);
  idle_packers_.push_back(std::move(packer));
}

bool PngStripes::add(std::uint32_t end, const ReadRow& read_row, const Executor& executor,
                     const std::function<bool()>& instead) {
  if (!good_) return true;
  const std::uint32_t top = next_row_;
  const std::uint32_t rows = rows_per_stripe(head_);
  std::vector<Stripe> stripes((end - top + rows - 1) / rows);
  std::atomic<bool> is_done = false;
  executor.run(1 + stripes.size(), [&](std::size_t task) {
    if (task == 0) {
      is_done = instead && instead();
    } else if (!is_done) {
      const std::uint32_t from = top + static_cast<std::uint32_t>(task - 1) * rows;
      std::unique_ptr<Packer> packer = take_packer();
      stripes[task - 1] = packer->stripe(head_, from, std::min(from + rows, end), read_row);
      give_back(std::move(packer));
    }
  });
  if (is_done) return false;
  if (next_row_ == 0) write(file_head(head_));
  for (Stripe& each : stripes) {
    write(std::exchange(each.chunk, {}));
    checksum_ = joint_adler32(checksum_, each.checksum, each.bytes);
  }
  next_row_ = end;
  return true;
}

bool PngStripes::finish() {
  write(chunk_bytes({"IDAT", zlib_end(checksum_)}) + chunk_bytes({"IEND", {}}));
  return good_;
}

std::uint32_t PngStripes::rows_per_stripe(const PngHead& head) {
  return static_cast<std::uint32_t>(std::max<std::size_t>(1, stripe_bytes(head.pixels) / (1 + head.bytes_per_row())));
}

}  // namespace burin::output
