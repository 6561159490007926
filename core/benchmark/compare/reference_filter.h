// Which points of a reference surface are judged.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <functional>

namespace octacut {

// True for the points of the reference that count: those that enough views
// see, say. Points outside are neither asked for (recall) nor held against
// the mesh (samples of the mesh whose closest point they are do not count).
// Empty: all count. Called from many threads.
using ReferenceFilter =
    std::function<bool(uint32_t triangle, const Eigen::Vector3d& point)>;

}  // namespace octacut
