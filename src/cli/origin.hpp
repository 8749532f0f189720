#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <burin/params/read_context.hpp>
#include <burin/preset/piece.hpp>
#include <cli/draw_request.hpp>
#include <cli/preset_library.hpp>

namespace burin::cli {

/// What is known of a piece once it has been read and before it is planned.
struct ReadPiece {
  preset::About about;
  std::uint64_t seed = 1;
  std::vector<params::DataDigest> data;
  std::vector<std::string> warnings{};  ///< for people
};

/// What goes into a file so that it can be drawn again: the text of the preset and every choice of the command line
/// that this output depends on, as a TOML document. The same request gives the same bytes; no path, date or host is in
/// it. Values are the texts that the options take.
std::string origin_record(const DrawRequest& request, const BackEnd& back_end, const PresetText& preset,
                          const ReadPiece& piece);

Origin make_origin(const DrawRequest& request, const BackEnd& back_end, const PresetText& preset,
                   const ReadPiece& piece);

/// A TOML string on one line: "a \"b\"".
std::string toml_string(std::string_view text);

/// A TOML string over several lines that keeps the text readable and gives every byte back, line ends too.
std::string toml_text(std::string_view text);

}  // namespace burin::cli
