#pragma once

namespace burin {

/// Prints the broken contract with its place and aborts: a caller's mistake, never a user's.
[[noreturn]] void contract_broken(const char* condition, const char* file, int line);

}  // namespace burin

/// A caller's obligation. Checked in every build: none stands in a hot loop.
#define BURIN_EXPECT(condition)                                                 \
  do {                                                                          \
    if (!(condition)) ::burin::contract_broken(#condition, __FILE__, __LINE__); \
  } while (false)
