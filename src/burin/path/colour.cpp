#include <burin/path/colour.hpp>
