#include <burin/output/back_ends.hpp>
