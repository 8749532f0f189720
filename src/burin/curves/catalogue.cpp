#include <burin/curves/family.hpp>
