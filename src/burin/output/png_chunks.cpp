#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include <burin/output/deflate.hpp>
#include <burin/output/origin_text.hpp>
#include <burin/output/png_chunks.hpp>

namespace burin::output {

namespace {

/// `text` in Latin-1 when it has printable characters of Latin-1 and line feeds only, as a tEXt chunk asks.
std::optional<std::string> latin1(const std::string& text) {
  std::string narrow;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<std::uint8_t>(text[i]);
    if (byte == '\n' || (byte >= 0x20 && byte < 0x7F)) {
      narrow += text[i];
    } else if ((byte == 0xC2 || byte == 0xC3) && i + 1 < text.size()) {
      const unsigned code = (byte & 3U) << 6U | (static_cast<std::uint8_t>(text[++i]) & 0x3FU);
      if (code < 0xA0) return std::nullopt;
      narrow += static_cast<char>(code);
    } else {
      return std::nullopt;
    }
  }
  return narrow;
}

PngChunk text_chunk(std::string_view keyword, const std::string& text) {
  const std::string carried = carried_text(text);
  std::string data(keyword);
  data += '\0';
  if (const std::optional<std::string> narrow = latin1(carried)) return {"tEXt", data + *narrow};
  data += '\0';  // not compressed
  data += '\0';  // the method of compression
  data += '\0';  // no language
  data += '\0';  // no translated keyword
  return {"iTXt", data + carried};
}

PngChunk resolution_chunk(double dots_per_mm) {
  constexpr char per_metre = 1;
  const auto dots = static_cast<std::uint32_t>(std::clamp(std::floor(dots_per_mm * 1000.0 + 0.5), 1.0, 2147483647.0));
  const std::string number = big_endian(dots);
  return {"pHYs", number + number + per_metre};
}

}  // namespace

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (unsigned shift = 32; shift > 0;) {
    shift -= 8;
    bytes += static_cast<char>(number >> shift & 0xFFU);
  }
  return bytes;
}

std::string chunk_bytes(const PngChunk& chunk) {
  std::string bytes;
  bytes.reserve(4 + chunk.type.size() + chunk.data.size() + 4);
  bytes += big_endian(static_cast<std::uint32_t>(chunk.data.size()));
  bytes += chunk.type;
  bytes += chunk.data;
  bytes += big_endian(crc32_of(std::string_view(bytes).substr(4)));
  return bytes;
}

std::vector<PngChunk> png_chunks(const Origin& origin, double dots_per_mm) {
  constexpr char perceptual = 0;
  std::vector<PngChunk> chunks = {{"sRGB", std::string(1, perceptual)}, resolution_chunk(dots_per_mm)};
  const std::pair<std::string_view, std::string> texts[] = {{"Title", origin.title},
                                                            {"Author", origin.author},
                                                            {"Description", origin.summary},
                                                            {"Software", "burin"},
                                                            {"burin-origin", origin.record}};
  for (const auto& [keyword, text] : texts) {
    if (!text.empty()) chunks.push_back(text_chunk(keyword, text));
  }
  return chunks;
}

}  // namespace burin::output
