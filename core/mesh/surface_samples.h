// Points spread evenly over a surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// The areas of the triangles from `begin` to `end` (excluded), summed up to
// and including each of them.
std::vector<double> CumulativeAreas(const IndexedMesh& mesh,
                                    size_t begin,
                                    size_t end);

// A point of a triangle; evenly distributed if u and v are so in [0, 1).
Eigen::Vector3d PointInTriangle(const IndexedMesh& mesh,
                                uint32_t triangle,
                                double u,
                                double v);

struct SurfaceSample {
  Eigen::Vector3d point;
  uint32_t triangle;
};

// `count` points, each of which stands for the same area: the surface, laid
// out triangle after triangle, is cut into `count` pieces of equal area and
// each piece gets one point. Within a triangle the points follow Roberts' R2
// sequence, so that large triangles are covered evenly too. Means over the
// samples are thus area-weighted means over the surface. The same seed gives
// the same points for any number of threads. In the order of the triangles.
// Throws InputError when the mesh has no area or coordinates that are not
// finite.
std::vector<SurfaceSample> SampleSurface(const IndexedMesh& mesh,
                                         size_t count,
                                         uint64_t seed,
                                         const Context& context);

}  // namespace octacut
