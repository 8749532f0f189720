#pragma once

#include <string_view>
#include <vector>

#include <burin/output/pdf/file.hpp>
#include <burin/path/sheet.hpp>

namespace burin::output::pdf {

/// A page in the making: its file, the streams of its content and what they name.
///
/// Content comes in chunks, each compressed and gone before the next: those of the page itself, or of a group that is
/// painted as a whole.
class Document {
 public:
  Document(ByteSink& bytes, const Sheet& sheet) : file_(bytes), sheet_(sheet) {}

  bool ok() const { return file_.ok(); }

  /// Ends a chunk of content.
  void add_chunk(std::string_view operators);

  /// Chunks up to end_group() are a group's, in units of `unit_mm`; each must be whole in itself.
  void begin_group(double unit_mm);
  /// Returns the operators that paint the group with `opacity`.
  std::string end_group(double opacity);

  /// Writes a figure; its operators are /F0 Do, /F1 Do ... in the order of these calls.
  void add_figure(std::string_view operators);

  /// Writes all that is known only at the end.
  Result<Done> finish();

 private:
  std::string figure_names() const;
  std::string resources() const;

  File file_;
  const Sheet& sheet_;
  std::vector<ObjectId> figures_;
  std::vector<ObjectId> page_chunks_;
  std::string group_box_;  ///< empty: no group is begun
  std::vector<ObjectId> group_chunks_;
  struct Group {
    ObjectId form = 0;
    double opacity = 1.0;
  };
  std::vector<Group> groups_;
};

/// The operators around a layer's content.
std::string layer_begin(std::size_t layer);
std::string layer_end();

}  // namespace burin::output::pdf
