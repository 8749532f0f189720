#include <cli/file_io.hpp>
#include <cli/picture_file.hpp>

namespace burin::cli {

Result<data::Image> read_picture(const std::string& path) {
  constexpr std::size_t largest_bytes = std::size_t{512} << 20U;
  const Result<std::string> bytes = read_file(path, path, largest_bytes);
  if (!bytes) return bytes.problems();
  return data::read_png(*bytes, path);
}

}  // namespace burin::cli
