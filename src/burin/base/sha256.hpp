#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace burin {

/// SHA-256 (FIPS 180-4) as it comes in: feed it, then ask for the digest once.
class Sha256 {
 public:
  void add(std::string_view bytes);
  /// 64 lower-case hexadecimal digits. Ends the hash: nothing may be added afterwards.
  std::string hex_digest();

 private:
  void compress(const unsigned char* block);

  std::uint32_t state_[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                             0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  unsigned char pending_[64] = {};
  std::uint64_t length_bytes_ = 0;
};

std::string sha256_hex(std::string_view bytes);

}  // namespace burin
