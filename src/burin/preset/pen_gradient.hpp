#pragma once

#include <cstddef>
#include <vector>

#include <burin/preset/piece.hpp>

namespace burin::preset {

/// `count` pens from one to another, both included: colours by mix_colours, widths and printers' inks in equal steps.
/// Those between are called "ink to red 2/6". One pen alone is the first.
std::vector<NamedPen> pens_between(const NamedPen& from, const NamedPen& to, std::size_t count);

}  // namespace burin::preset
