#include <cstddef>
#include <cstdint>

#include <burin/base/check.hpp>
#include <burin/data/image.hpp>

/// Any bytes as a PNG: a picture has all of its pixels, a problem has words.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto image = burin::data::read_png({reinterpret_cast<const char*>(bytes), size}, "fuzz.png");
  if (image) {
    BURIN_EXPECT(image->width > 0 && image->height > 0);
    BURIN_EXPECT(image->rgba.size() ==
                 4 * static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height));
  } else {
    BURIN_EXPECT(!image.problems().front().message.empty());
  }
  return 0;
}
