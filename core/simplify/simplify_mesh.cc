#include "core/simplify/simplify_mesh.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/mesh/normals.h"
#include "core/mesh/self_intersections.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 4096;
// Numbers of triangles between which bisection stops: their ratio.
constexpr double kBisectionRatio = 1.01;

// Whether a triangle has the corners that it has in the full mesh.
bool IsUntouched(const CollapsedMesh& collapsed,
                 const IndexedMesh& full,
                 uint32_t triangle) {
  const auto& corners = collapsed.mesh.triangles[triangle];
  const auto& sources = full.triangles[collapsed.source_triangles[triangle]];
  return std::all_of(corners.begin(), corners.end(), [&](uint32_t corner) {
    return std::any_of(sources.begin(), sources.end(), [&](uint32_t source) {
      return collapsed.mesh.positions[corner] == full.positions[source];
    });
  });
}

// From now on, those `count` vertices stay that were moved last onto each
// marked corner: what was moved before does less harm.
void HoldLast(const CollapsedMesh& collapsed,
              const std::vector<uint8_t>& is_corner,
              size_t count,
              std::vector<uint8_t>* held) {
  struct Moved {
    uint32_t owner;
    uint32_t when;
    uint32_t vertex;
  };
  std::vector<Moved> moved;
  for (uint32_t v = 0; v < collapsed.owners.size(); ++v) {
    if (is_corner[collapsed.owners[v]] != 0 && collapsed.moved_at[v] > 0) {
      moved.push_back({collapsed.owners[v], collapsed.moved_at[v], v});
    }
  }
  std::sort(moved.begin(), moved.end(), [](const Moved& a, const Moved& b) {
    return a.owner != b.owner ? a.owner < b.owner : a.when > b.when;
  });
  for (size_t i = 0; i < moved.size(); ++i) {
    if (i < count || moved[i - count].owner != moved[i].owner) {
      (*held)[moved[i].vertex] = 1;
    }
  }
}

// Holds vertices that went into triangles that intersect, `count` for each of
// their corners. Returns how many pairs are the full mesh's own.
size_t HoldIntersecting(const CollapsedMesh& collapsed,
                        const IndexedMesh& full,
                        size_t count,
                        const Context& context,
                        std::vector<uint8_t>* held) {
  const SelfIntersections found = FindSelfIntersections(
      collapsed.mesh, context, std::numeric_limits<size_t>::max());
  std::vector<uint8_t> is_corner(collapsed.mesh.positions.size());
  size_t num_old = 0;
  for (const auto& [first, second] : found.examples) {
    if (IsUntouched(collapsed, full, first) &&
        IsUntouched(collapsed, full, second)) {
      ++num_old;
      continue;
    }
    for (const uint32_t triangle : {first, second}) {
      for (const uint32_t corner : collapsed.mesh.triangles[triangle]) {
        is_corner[corner] = 1;
      }
    }
  }
  if (found.examples.size() > num_old) {
    held->resize(full.positions.size());
    HoldLast(collapsed, is_corner, count, held);
  }
  return num_old;
}

// Whether all vertices of `full` are within `limit` of `mesh`.
bool IsWithin(double limit,
              const IndexedMesh& full,
              const IndexedMesh& mesh,
              const Context& context) {
  const RayScene scene(mesh);
  std::atomic<bool> is_within = true;
  ParallelEach(context, full.positions.size(), kGrain, [&](size_t v) {
    if (is_within && scene.ClosestPoint(full.positions[v]).distance > limit) {
      is_within = false;
    }
  });
  return is_within;
}

}  // namespace

SimplifiedMesh SimplifyTo(size_t num_triangles,
                          const CollapseReplay& replay,
                          const Context& context) {
  const Phase phase(context, "simplification: intersections");
  SimplifiedMesh result;
  std::vector<uint8_t> held;
  // Each pass holds at least one more vertex, so it ends: a triangle whose
  // vertices are all held is one of the full mesh.
  while (true) {
    CollapsedMesh collapsed = replay.Run(num_triangles, held);
    const auto num_held = std::count(held.begin(), held.end(), 1);
    // Twice as many each time, so that it takes few of them.
    const size_t count = size_t{1}
                         << std::min<size_t>(result.summary.num_repairs, 31);
    result.summary.num_old_intersections =
        HoldIntersecting(collapsed, replay.Full(), count, context, &held);
    if (std::count(held.begin(), held.end(), 1) == num_held) {
      result.summary.num_held = size_t(num_held);
      result.mesh = std::move(collapsed.mesh);
      break;
    }
    ++result.summary.num_repairs;
  }
  result.mesh.normals = ComputeVertexNormals(result.mesh, context);
  return result;
}

SimplifiedMesh SimplifyWithin(
    double max_distance,
    const std::function<double(const IndexedMesh&)>& distance_to_full,
    const CollapseReplay& replay,
    const Context& context) {
  // The number of triangles is `too_few` where that is too far.
  auto too_few = double(replay.LeastTriangles());
  auto enough = double(replay.Full().triangles.size());
  {
    const Phase phase(context, "simplification: distance");
    while (enough > kBisectionRatio * too_few && enough > too_few + 2) {
      const double middle = std::floor(std::sqrt(too_few * enough));
      const CollapsedMesh collapsed = replay.Run(size_t(middle), {});
      const bool is_within =
          IsWithin(max_distance, replay.Full(), collapsed.mesh, context);
      (is_within ? enough : too_few) = middle;
    }
  }
  // So far only vertices were measured, and no vertex had to stay.
  while (true) {
    SimplifiedMesh result = SimplifyTo(size_t(enough), replay, context);
    const double distance = distance_to_full(result.mesh);
    // Rounding may keep even the full mesh from a distance of 0.
    if (distance <= max_distance ||
        enough >= double(replay.Full().triangles.size())) {
      return result;
    }
    enough = std::ceil(kBisectionRatio * enough);
  }
}

}  // namespace octacut
