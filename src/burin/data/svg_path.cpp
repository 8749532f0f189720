#include <burin/data/svg_path.hpp>
