#include <burin/data/csv.hpp>
