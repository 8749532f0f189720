#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <system_error>
#include <utility>

#include <muParserBase.h>

#include <burin/base/check.hpp>
#include <burin/base/math.hpp>
#include <burin/expr/expression.hpp>
#include <burin/expr/functions.hpp>
#include <burin/expr/scan.hpp>

namespace burin::expr {

namespace {

double truth(bool value) {
  return value ? 1.0 : 0.0;
}

struct Operator {
  const char* name;
  Binary call;
  unsigned precedence;
  mu::EOprtAssociativity associativity = mu::oaLEFT;
};

/// All binary operators. muParser's own set has std::pow for '^' and can only be replaced as a whole.
constexpr std::array operators{
    Operator{"||", [](double a, double b) { return truth(a != 0.0 || b != 0.0); }, mu::prLOR},
    Operator{"&&", [](double a, double b) { return truth(a != 0.0 && b != 0.0); }, mu::prLAND},
    Operator{"==", [](double a, double b) { return truth(a == b); }, mu::prCMP},
    Operator{"!=", [](double a, double b) { return truth(a != b); }, mu::prCMP},
    Operator{"<=", [](double a, double b) { return truth(a <= b); }, mu::prCMP},
    Operator{">=", [](double a, double b) { return truth(a >= b); }, mu::prCMP},
    Operator{"<", [](double a, double b) { return truth(a < b); }, mu::prCMP},
    Operator{">", [](double a, double b) { return truth(a > b); }, mu::prCMP},
    Operator{"+", [](double a, double b) { return a + b; }, mu::prADD_SUB},
    Operator{"-", [](double a, double b) { return a - b; }, mu::prADD_SUB},
    Operator{"*", [](double a, double b) { return a * b; }, mu::prMUL_DIV},
    Operator{"/", [](double a, double b) { return a / b; }, mu::prMUL_DIV},
    Operator{"^", math::pow, mu::prPOW, mu::oaRIGHT},
};

/// muParser's hook for numbers: reads one at the start of `text`, without a locale.
int read_number(const char* text, int* position, double* value) {
  const bool number = (*text >= '0' && *text <= '9') || *text == '.';  // never "inf" or "nan"
  if (!number) return 0;
  const auto [end, error] = std::from_chars(text, text + std::strlen(text), *value);
  if (error != std::errc{}) return 0;
  *position += static_cast<int>(end - text);
  return 1;
}

/// muParser without anything of its own: it orders the operations, we define all of them.
class Parser final : public mu::ParserBase {
 public:
  Parser() {
    EnableBuiltInOprt(false);
    Init();
    AddValIdent(read_number);
  }

 private:
  void InitCharSets() override {
    DefineNameChars("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ");
    DefineOprtChars("+-*/^<>=!&|");
    DefineInfixOprtChars("-!");
  }
  void InitFun() override {
    for (const Function& function : functions()) {
      std::visit([&](auto call) { DefineFun(std::string(function.name), call); }, function.call);
    }
  }
  void InitConst() override {}  // after the variables, which may hide them
  void InitOprt() override {
    constexpr bool foldable = true;
    for (const Operator& row : operators) {
      DefineOprt(row.name, row.call, row.precedence, row.associativity, foldable);
    }
    DefineInfixOprt("-", [](double a) { return -a; });
    DefineInfixOprt("!", [](double a) { return truth(a == 0.0); });
  }
};

double call_plane_function(void* function, double x, double y) {
  return (*static_cast<const PlaneFunction*>(function)->value)(x, y);
}

bool is_name(std::string_view text) {
  return !text.empty() && !(text.front() >= '0' && text.front() <= '9') && std::ranges::all_of(text, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  });
}

}  // namespace

/// A parser and the storage its variables are bound to.
struct Expression::Machine {
  std::string text;
  Scan scanned;
  std::vector<std::string> names;
  std::vector<PlaneFunction> functions;
  std::vector<double> values;
  Parser parser;

  Machine(std::string_view source, Scan checked, std::vector<std::string> variables, std::vector<PlaneFunction> own)
      : text(source),
        scanned(std::move(checked)),
        names(std::move(variables)),
        functions(std::move(own)),
        values(names.size()) {
    for (PlaneFunction& function : functions) {
      parser.DefineFunUserData(function.name, call_plane_function, &function, false);
    }
    for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &values[i]);
    for (const Constant& constant : constants()) {
      const std::string name(constant.name);
      if (std::ranges::find(names, name) == names.end()) parser.DefineConst(name, constant.value);
    }
    parser.SetExpr(scanned.formula);
    static_cast<void>(parser.Eval());  // builds the code; from now on nothing can fail
  }
  Machine(const Machine&) = delete;  // the parser holds addresses of `values`
  Machine& operator=(const Machine&) = delete;
};

Result<Expression> Expression::compile(std::string_view text, std::span<const std::string_view> variables,
                                       const Where& where, std::span<const PlaneFunction> functions) {
  BURIN_EXPECT(std::ranges::all_of(variables, is_name));
  Result<Scan> scanned = scan(text, variables, where, functions);
  if (!scanned) return scanned.problems();
  try {
    return Expression(std::make_unique<Machine>(text, *std::move(scanned),
                                                std::vector<std::string>(variables.begin(), variables.end()),
                                                std::vector<PlaneFunction>(functions.begin(), functions.end())));
  } catch (const mu::ParserError& error) {
    return Problem{where, "'" + std::string(text) + "' is no expression: " + error.GetMsg()};
  }
}

Expression::Expression(std::unique_ptr<Machine> machine) : machine_(std::move(machine)) {}
Expression::Expression()
    : machine_(
          std::make_unique<Machine>("0", Scan{"0", {}}, std::vector<std::string>{}, std::vector<PlaneFunction>{})) {}
Expression::Expression(const Expression& other)
    : machine_(std::make_unique<Machine>(other.machine_->text, other.machine_->scanned, other.machine_->names,
                                         other.machine_->functions)) {}
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(const Expression& other) {
  return *this = Expression(other);
}
Expression& Expression::operator=(Expression&&) noexcept = default;
Expression::~Expression() = default;

double Expression::operator()(std::span<const double> values) const {
  BURIN_EXPECT(values.size() == machine_->values.size());
  std::ranges::copy(values, machine_->values.begin());
  return machine_->parser.Eval();
}

const std::string& Expression::text() const {
  return machine_->text;
}

bool Expression::uses(std::size_t variable) const {
  BURIN_EXPECT(variable < machine_->scanned.uses.size());
  return machine_->scanned.uses[variable];
}

bool Expression::is_constant() const {
  return std::ranges::find(machine_->scanned.uses, true) == machine_->scanned.uses.end();
}

Result<double> evaluate_constant(std::string_view text, const Where& where) {
  const Result<Expression> compiled = Expression::compile(text, {}, where);
  if (!compiled) return compiled.problems();
  const double value = (*compiled)({});
  if (std::isfinite(value)) return value;
  return Problem{where, "the value of '" + std::string(text) + "' is " +
                            (std::isnan(value) ? "not a number" : "infinite") + "; a finite number is expected"};
}

std::vector<std::string_view> function_names() {
  std::vector<std::string_view> names;
  for (const Function& function : functions()) names.push_back(function.name);
  for (const Constant& constant : constants()) names.push_back(constant.name);
  return names;
}

}  // namespace burin::expr
