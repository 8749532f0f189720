#include <burin/preset/plan.hpp>
