#pragma once

namespace burin {

/// Prints the broken contract with its place and aborts: a caller's mistake, never a user's.
/// (std::source_location would do, but clang 14 lacks what it needs.)
[[noreturn]] void contract_broken(const char* condition, const char* file = __builtin_FILE(),
                                  int line = __builtin_LINE());

}  // namespace burin

/// A caller's obligation. Checked in every build: none stands in a hot loop.
#define BURIN_EXPECT(condition)                             \
  do {                                                      \
    if (!(condition)) ::burin::contract_broken(#condition); \
  } while (false)
