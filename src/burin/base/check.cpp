#include <burin/base/check.hpp>
#include <cstdio>
#include <cstdlib>

namespace burin {

void contract_broken(const char* condition, std::source_location where) {
  std::fprintf(stderr, "%s:%u: contract broken: %s\n", where.file_name(), where.line(), condition);
  std::abort();
}

}  // namespace burin
