#include <string>

#include <gtest/gtest.h>

#include <burin/base/sha256.hpp>

namespace burin {
namespace {

// Known answers: FIPS 180-4 examples and NIST's long message of a million letters.
TEST(Sha256, KnownAnswers) {
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_hex(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, PiecesGiveTheDigestOfTheWhole) {
  // Every length around the block and padding limits, cut at every place.
  for (std::size_t length = 0; length <= 130; ++length) {
    std::string text;
    for (std::size_t i = 0; i < length; ++i) text += static_cast<char>(i * 7);
    const std::string whole = sha256_hex(text);
    for (std::size_t cut = 0; cut <= length; cut += 13) {
      Sha256 hash;
      hash.add(std::string_view(text).substr(0, cut));
      hash.add("");
      hash.add(std::string_view(text).substr(cut));
      EXPECT_EQ(hash.hex_digest(), whole) << length << " cut at " << cut;
    }
  }
}

}  // namespace
}  // namespace burin
