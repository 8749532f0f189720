#include <burin/base/sha256.hpp>
