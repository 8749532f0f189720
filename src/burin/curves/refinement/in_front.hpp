#pragma once

#include <burin/base/problem.hpp>
#include <burin/geom/camera.hpp>
#include <burin/params/read_context.hpp>

namespace burin::curves {

/// Whether a curve of which no point has a smaller depth has a picture: in perspective all of it must lie in front of
/// the eye. False after reporting at `where`.
bool check_in_front(double least_depth, const Camera& camera, const Where& where, params::ReadContext& context);

}  // namespace burin::curves
