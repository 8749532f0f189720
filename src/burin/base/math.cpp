#include <burin/base/math.hpp>
