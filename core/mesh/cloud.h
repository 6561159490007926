// Point clouds among surfaces: every point is a triangle without area, which
// has closest points, but no samples of its area.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/mesh/surface_samples.h"

namespace octacut {

// The points of a mesh without triangles as triangles; other meshes as they
// are.
inline IndexedMesh PointsAsTriangles(IndexedMesh mesh) {
  if (mesh.triangles.empty()) {
    mesh.triangles.reserve(mesh.positions.size());
    for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
      mesh.triangles.push_back({i, i, i});
    }
  }
  return mesh;
}

// A triangle of a mesh may be a point, too: all of them are.
inline bool IsCloud(const IndexedMesh& mesh) {
  return std::all_of(
      mesh.triangles.begin(), mesh.triangles.end(), [](const auto& triangle) {
        return triangle[0] == triangle[1] && triangle[1] == triangle[2];
      });
}

// At most `count` points of PointsAsTriangles, spread evenly over their order.
inline std::vector<SurfaceSample> SampleCloud(const IndexedMesh& cloud,
                                              size_t count) {
  const size_t total = cloud.positions.size();
  const size_t taken = std::min(count, total);
  std::vector<SurfaceSample> samples;
  samples.reserve(taken);
  for (size_t i = 0; i < taken; ++i) {
    const auto index = static_cast<uint32_t>(i * total / taken);
    samples.push_back({cloud.positions[index], index});
  }
  return samples;
}

}  // namespace octacut
