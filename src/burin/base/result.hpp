#pragma once

#include <string>
#include <utility>
#include <variant>

#include <burin/base/check.hpp>
#include <burin/base/problem.hpp>

namespace burin {

/// A value, or every problem that kept it from being made. Rooms hand these over instead of throwing.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}  // NOLINT(google-explicit-constructor)
  Result(Problems problems)                                              // NOLINT(google-explicit-constructor)
      : state_(std::in_place_index<1>, std::move(problems)) {
    BURIN_EXPECT(!std::get<1>(state_).empty());
  }
  Result(Problem problem) : Result(Problems{std::move(problem)}) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(value()); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Problems& problems() const {
    BURIN_EXPECT(!ok());
    return std::get<1>(state_);
  }

 private:
  T& value() {
    BURIN_EXPECT(ok());
    return std::get<0>(state_);
  }
  const T& value() const {
    BURIN_EXPECT(ok());
    return std::get<0>(state_);
  }

  std::variant<T, Problems> state_;
};

/// Success without a value.
struct Done {};

}  // namespace burin
