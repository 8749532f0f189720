#include <cstddef>
#include <cstdint>

#include <burin/burin.hpp>

/// Any bytes as a preset: problems or a plan; a plan that is not too big is drawn.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto plan = burin::load({"fuzz.toml", {reinterpret_cast<const char*>(bytes), size}});
  if (!plan) return 0;
  burin::StringSink svg;
  static_cast<void>(burin::write(*plan, "svg", svg, {}, 1e5));
  return 0;
}
