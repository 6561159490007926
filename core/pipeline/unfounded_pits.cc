#include "core/pipeline/unfounded_pits.h"

#include <array>

#include "core/base/parallel.h"
#include "core/mesh/disjoint_sets.h"

namespace octacut {
namespace {

constexpr size_t kDepthGrain = 1024;
// Voxels. What lies less deep in the hull connects pits and hollows with one
// another.
constexpr double kDeep = 2;
// Vertices of a part that is judged, about one per voxel: the area of five
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
  ParallelEach(context, is_deep.size(), kDepthGrain, [&](size_t v) {
    is_deep[v] = hull.ClosestPoint(mesh.positions[v]).distance > depth;
  });
  return is_deep;
}

// How well the views agree about a connected part of the surface.
struct PartAgreement {
  size_t num_vertices = 0;
  size_t num_measured = 0;
  double sum = 0;  // over those that are measured

  // `mean` is one of SurfaceAgreement::MeansAround.
  void Add(float mean) {
    ++num_vertices;
    if (mean != SurfaceAgreement::kUnmeasured) {
      ++num_measured;
      sum += mean;
    }
  }
  bool IsUnfounded() const {
    return num_vertices >= kMinVertices && 2 * num_measured > num_vertices &&
           sum < kNoAgreement * double(num_measured);
  }
};

// Joins the ends of the edges whose ends are both in the set.
DisjointSets JoinWithin(const std::vector<uint8_t>& set,
                        const IndexedMesh& mesh) {
  DisjointSets parts(set.size());
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const uint32_t from = triangle[i];
      const uint32_t to = triangle[(i + 1) % 3];
      if (set[from] && set[to]) {
        parts.Unite(from, to);
      }
    }
  }
  return parts;
}

}  // namespace

std::vector<uint8_t> FindUnfoundedPits(const MeasuredSurface& cut,
                                       const std::vector<float>& means,
                                       const RayScene& hull,
                                       double voxel,
                                       const Context& context) {
  const std::vector<uint32_t>& point_of = cut.agreement.points.point_of;
  const std::vector<uint8_t> is_deep =
      FindDeepVertices(cut.mesh, hull, kDeep * voxel, context);
  DisjointSets parts = JoinWithin(is_deep, cut.mesh);
  std::vector<PartAgreement> agreements(is_deep.size());
  for (uint32_t v = 0; v < is_deep.size(); ++v) {
    if (is_deep[v]) {
      agreements[parts.Find(v)].Add(means[point_of[v]]);
    }
  }
  std::vector<uint8_t> in_pit(is_deep.size());
  for (uint32_t v = 0; v < is_deep.size(); ++v) {
    in_pit[v] = is_deep[v] && agreements[parts.Find(v)].IsUnfounded();
  }
  return in_pit;
}

}  // namespace octacut
