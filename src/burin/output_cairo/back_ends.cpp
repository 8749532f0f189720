#include <burin/output_cairo/back_ends.hpp>
