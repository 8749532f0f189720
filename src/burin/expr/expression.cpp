#include <burin/expr/expression.hpp>
