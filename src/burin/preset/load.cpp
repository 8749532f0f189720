#include <burin/preset/load.hpp>
