#pragma once

#include <source_location>

namespace burin {

/// Prints the broken contract with its place and aborts: a caller's mistake, never a user's.
[[noreturn]] void contract_broken(const char* condition, std::source_location where = std::source_location::current());

}  // namespace burin

/// A caller's obligation. Checked in every build: none stands in a hot loop.
#define BURIN_EXPECT(condition)                             \
  do {                                                      \
    if (!(condition)) ::burin::contract_broken(#condition); \
  } while (false)
