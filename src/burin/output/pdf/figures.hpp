#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <burin/path/recording.hpp>

namespace burin::output::pdf {

/// How many units of a form a figure reaches from its origin.
inline constexpr double form_size = 1e6;

/// How far a box reaches from the origin along either axis.
double reach(const Box2& box);

/// A figure as the text of a form: its points are whole numbers up to form_size.
struct FigureForm {
  std::string operators;
  double units_per_figure_unit = 1.0;
};

/// The form of a figure; nothing for one that is shorter as it is, is too large to keep, or has a dot, which needs to
/// know its pen.
std::optional<FigureForm> figure_form(const Figure& figure);

/// The figures that have a form, by what they look like: where in memory a figure is tells nothing. Memory: at most a
/// megabyte.
class Figures {
 public:
  struct Known {
    std::size_t index = 0;  ///< of the form
    double units_per_figure_unit = 1.0;
  };

  /// The figure, when it has been added.
  std::optional<Known> find(const Figure& figure) const;
  /// Whether another can be kept.
  bool has_room_for(const Figure& figure) const;
  /// Pre: has_room_for(figure), and it is not known yet.
  Known add(const Figure& figure, double units_per_figure_unit);

 private:
  struct Kept {
    Figure figure;
    Known known;
  };
  std::vector<Kept> kept_;
  std::size_t points_ = 0;
};

}  // namespace burin::output::pdf
