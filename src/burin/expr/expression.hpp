#pragma once

#include <burin/base/result.hpp>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Arithmetic written in presets: Z = f(x, y), numbers such as "sqrt(3)/6".
///
/// Numbers, + - * / ^ (right associative, -2^2 = -4), comparisons, && || !, a ? b : c, and the functions of
/// function_names(). sin, cos ... take radians, sind, cosd ... degrees. The same text gives the same bits on every
/// machine: no libm function is used.
namespace burin::expr {

/// A compiled expression. Copies share the text but not the machine, so copies may be used on different threads.
class Expression {
 public:
  /// Compiles `text`, which may use `variables`. A problem says what is wrong, where (column inside the text, added to
  /// `where`), with a "did you mean" for unknown names.
  static Result<Expression> compile(std::string_view text, std::span<const std::string_view> variables,
                                    const Where& where);

  Expression();
  Expression(const Expression&);
  Expression(Expression&&) noexcept;
  Expression& operator=(const Expression&);
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// The value for these variables, in the order they were given to compile; may be NaN or infinite. Not to be called
  /// on one object from two threads at once. About 100 ns.
  double operator()(std::span<const double> values) const;

  const std::string& text() const;
  /// Whether variable i (in the order given to compile) occurs.
  bool uses(std::size_t variable) const;
  /// Whether anything but constants occurs.
  bool is_constant() const;

 private:
  struct Machine;
  std::unique_ptr<Machine> machine_;
};

/// The value of an expression without variables; a problem when it does not compile or is not finite.
Result<double> evaluate_constant(std::string_view text, const Where& where);

/// Every function and constant an expression may use, for help and suggestions.
std::vector<std::string_view> function_names();

}  // namespace burin::expr
