#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <burin/base/plane_function.hpp>
#include <burin/base/result.hpp>

/// Arithmetic written in presets: Z = f(x, y), numbers such as "sqrt(3)/6".
///
/// Numbers, names and, from the loosest to the tightest:
///   a ? b : c   (c may be another of its kind)
///   ||
///   &&
///   == != < <= > >=   (1 or 0)
///   + -
///   * /
///   - ! before a value
///   ^           (right associative: 2^3^2 = 512; -2^2 = -4)
/// Functions: sin cos tan asin acos atan atan2(y, x) in radians, the same with a final d (sind, atan2d) in degrees;
/// exp, log (natural), log10, log2, sqrt, cbrt, pow(a, b), hypot(a, b), abs, sign, floor, ceil, round (halves away from
/// 0), frac, min and max of any number, clamp(x, low, high), lerp(a, b, t), smoothstep(low, high, x), mod(a, b) with
/// the sign of b, noise(x, y) in [-1, 1], smooth, bumps about one unit apart. Constants: pi, tau, e; a variable of that
/// name hides them. Division by zero and the like give infinities and NaN, which are values, not errors.
///
/// At most 4096 characters and 100 nested parentheses. The same text gives the same bits on every machine: no libm
/// function and no locale is used.
namespace burin::expr {

/// A compiled expression. Copies share the text but not the machine, so copies may be used on different threads.
class Expression {
 public:
  /// Compiles `text`, which may use `variables` (names of letters, digits and _, at most 100 characters). A problem
  /// says what is wrong, where (column inside the text, added to `where`), with a "did you mean" for unknown names.
  /// `functions` may be called too; they hide built-in ones of the same name.
  static Result<Expression> compile(std::string_view text, std::span<const std::string_view> variables,
                                    const Where& where, std::span<const PlaneFunction> functions = {});

  /// The constant 0.
  Expression();
  Expression(const Expression&);
  Expression(Expression&&) noexcept;
  Expression& operator=(const Expression&);
  Expression& operator=(Expression&&) noexcept;
  ~Expression();

  /// The value for these variables, in the order they were given to compile; may be NaN or infinite. Not to be called
  /// on one object from two threads at once. About 5 ns an operation and what the functions take.
  double operator()(std::span<const double> values) const;

  const std::string& text() const;
  /// Whether variable i (in the order given to compile) occurs.
  bool uses(std::size_t variable) const;
  /// Whether anything but constants occurs.
  bool is_constant() const;

 private:
  struct Machine;
  explicit Expression(std::unique_ptr<Machine> machine);

  std::unique_ptr<Machine> machine_;
};

/// The value of an expression without variables; a problem when it does not compile or is not finite.
Result<double> evaluate_constant(std::string_view text, const Where& where);

/// Every function and constant an expression may use, for help and suggestions.
std::vector<std::string_view> function_names();

}  // namespace burin::expr
