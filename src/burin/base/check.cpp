#include <cstdio>
#include <cstdlib>

#include <burin/base/check.hpp>

namespace burin {

void contract_broken(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: contract broken: %s\n", file, line, condition);
  std::abort();
}

}  // namespace burin
