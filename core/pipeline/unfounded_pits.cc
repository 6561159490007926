#include "core/pipeline/unfounded_pits.h"

#include "core/base/parallel.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {
namespace {

constexpr size_t kDepthGrain = 1024;
// Voxels. What lies less deep in the hull connects pits and hollows with one
// another.
constexpr double kDeep = 2;
// Vertices of a part that is judged, about one a voxel: the area of five
// patches. What is smaller is part of the edges of hollows
// (docs/experiments/dents.md).
constexpr size_t kMinVertices = 15;
// Mean agreement up to which views do not agree: up to 0.05 in pits, from 0.11
// on in hollows of scenes with a truth (docs/experiments/dents.md).
constexpr double kNoAgreement = 0.07;

std::vector<uint8_t> FindDeepVertices(const IndexedMesh& mesh,
                                      const RayScene& hull,
                                      double depth,
                                      const Context& context) {
  std::vector<uint8_t> is_deep(mesh.positions.size());
  ParallelFor(
      context, is_deep.size(), kDepthGrain, [&](size_t begin, size_t end) {
        for (size_t v = begin; v < end; ++v) {
          is_deep[v] = hull.ClosestPoint(mesh.positions[v]).distance > depth;
        }
      });
  return is_deep;
}

// The part of the set that is connected with `first`; removes it from the set.
std::vector<uint32_t> TakePart(uint32_t first,
                               const VertexCorners& neighbors,
                               std::vector<uint8_t>* set) {
  std::vector<uint32_t> part = {first};
  (*set)[first] = 0;
  for (size_t k = 0; k < part.size(); ++k) {
    for (const uint32_t next : neighbors.Of(part[k])) {
      if ((*set)[next]) {
        (*set)[next] = 0;
        part.push_back(next);
      }
    }
  }
  return part;
}

// `means` are those of SurfaceAgreement::MeansAround.
bool IsUnfounded(const std::vector<uint32_t>& part,
                 const std::vector<uint32_t>& point_of,
                 const std::vector<float>& means) {
  double sum = 0;
  size_t count = 0;
  for (const uint32_t vertex : part) {
    const float mean = means[point_of[vertex]];
    if (mean != SurfaceAgreement::kUnmeasured) {
      sum += mean;
      ++count;
    }
  }
  return part.size() >= kMinVertices && 2 * count > part.size() &&
         sum < kNoAgreement * double(count);
}

}  // namespace

std::vector<uint8_t> FindUnfoundedPits(const MeasuredSurface& cut,
                                       const RayScene& hull,
                                       double voxel,
                                       const Context& context) {
  const IndexedMesh& mesh = cut.mesh;
  const VertexCorners neighbors =
      FindVertexNeighbors(mesh.positions.size(), mesh.triangles);
  const std::vector<float> means = cut.agreement.MeansAround();
  std::vector<uint8_t> is_deep =
      FindDeepVertices(mesh, hull, kDeep * voxel, context);
  std::vector<uint8_t> in_pit(is_deep.size(), 0);
  for (uint32_t v = 0; v < is_deep.size(); ++v) {
    if (!is_deep[v]) {
      continue;
    }
    const std::vector<uint32_t> part = TakePart(v, neighbors, &is_deep);
    if (IsUnfounded(part, cut.agreement.points.point_of, means)) {
      for (const uint32_t vertex : part) {
        in_pit[vertex] = 1;
      }
    }
  }
  return in_pit;
}

}  // namespace octacut
