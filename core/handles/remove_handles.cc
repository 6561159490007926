#include "core/handles/remove_handles.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "core/handles/half_edges.h"
#include "core/handles/handle_cutter.h"
#include "core/handles/handle_loops.h"
#include "core/handles/surface_homology.h"
#include "core/mesh/disjoint_sets.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {
namespace {

// How often other loops are tried where all that were chosen have failed.
constexpr int kMaxAttempts = 16;
// The longest loop around a tunnel in units of that around a bridge
// (docs/experiments/handles.md).
constexpr double kTunnelLength = 2;

using Vertices = std::vector<uint32_t>;

// Ascending: the same for a loop from wherever it is begun.
Vertices VerticesOf(const HalfEdges& half_edges, const HandleLoop& loop) {
  Vertices vertices;
  for (const uint32_t h : loop.half_edges) {
    vertices.push_back(half_edges.Origin(h));
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

// Those loops, ascending by length, of which no triangle touches two.
std::vector<HandleLoop> ChooseDisjoint(const std::vector<HandleLoop>& loops,
                                       const HalfEdges& half_edges,
                                       const std::set<Vertices>& refused) {
  std::vector<uint8_t> is_near(half_edges.NumVertices());
  std::vector<HandleLoop> chosen;
  for (const HandleLoop& loop : loops) {
    const Vertices vertices = VerticesOf(half_edges, loop);
    if (std::any_of(vertices.begin(),
                    vertices.end(),
                    [&](uint32_t v) { return is_near[v] != 0; }) ||
        refused.contains(vertices)) {
      continue;
    }
    chosen.push_back(loop);
    for (const uint32_t v : vertices) {
      for (const uint32_t h : half_edges.Leaving(v)) {
        is_near[half_edges.End(h)] = 1;
      }
    }
  }
  return chosen;
}

// Takes out loops, the longest first, until the others together do not
// separate: those that join what all of them would leave.
void KeepConnected(const HalfEdges& half_edges,
                   std::vector<HandleLoop>& loops) {
  std::vector<uint8_t> is_cut(half_edges.Size());
  for (const HandleLoop& loop : loops) {
    for (const uint32_t h : loop.half_edges) {
      is_cut[h] = is_cut[half_edges.Opposite(h)] = 1;
    }
  }
  DisjointSets pieces(half_edges.Size() / 3);
  for (uint32_t h = 0; h < half_edges.Size(); ++h) {
    if (!is_cut[h]) {
      pieces.Unite(h / 3, half_edges.Opposite(h) / 3);
    }
  }
  for (size_t i = loops.size(); i-- > 0;) {
    const uint32_t h = loops[i].half_edges[0];
    if (pieces.Unite(h / 3, half_edges.Opposite(h) / 3)) {
      loops.erase(loops.begin() + ptrdiff_t(i));
    }
  }
}

// Whether the surface faces the middle of the loop: what is cut is then free
// space, and it is filled.
bool IsAroundTunnel(const IndexedMesh& mesh,
                    const HalfEdges& half_edges,
                    const HandleLoop& loop) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const uint32_t h : loop.half_edges) {
    middle += mesh.positions[half_edges.Origin(h)];
  }
  middle /= double(loop.half_edges.size());
  double facing = 0;
  for (const uint32_t h : loop.half_edges) {
    for (const uint32_t triangle : {h / 3, half_edges.Opposite(h) / 3}) {
      const Eigen::Vector3d normal = AreaNormal(mesh, mesh.triangles[triangle]);
      facing += normal.dot(middle - mesh.positions[half_edges.Origin(h)]);
    }
  }
  return facing > 0;
}

// Whether a loop is short enough to be cut.
bool IsShort(const IndexedMesh& mesh,
             const HalfEdges& half_edges,
             const HandleLoop& loop,
             const RemoveHandlesOptions& options) {
  const double factor =
      IsAroundTunnel(mesh, half_edges, loop) ? kTunnelLength : 1;
  return loop.length <= factor * options.max_length ||
         (loop.length <= options.max_length_anywhere &&
          std::all_of(
              loop.half_edges.begin(), loop.half_edges.end(), [&](uint32_t h) {
                return loop.length <= options.max_length_at(
                                          mesh.positions[half_edges.Origin(h)]);
              }));
}

struct CutMesh {
  IndexedMesh mesh;
  size_t num_loops = 0;  // 0: there is no mesh
};

// Cuts those of `loops` that can be; the others are refused.
CutMesh CutLoops(const IndexedMesh& mesh,
                 const HalfEdges& half_edges,
                 std::vector<HandleLoop> loops,
                 double min_height,
                 const Context& context,
                 std::set<Vertices>* refused) {
  while (!loops.empty()) {
    HandleCutter cutter(mesh, half_edges);
    for (const HandleLoop& loop : loops) {
      cutter.Cut(loop);
    }
    const std::set<size_t> failed = cutter.FindFailed(min_height, context);
    if (failed.empty()) {
      return {cutter.TakeMesh(), loops.size()};
    }
    for (auto i = failed.rbegin(); i != failed.rend(); ++i) {
      refused->insert(VerticesOf(half_edges, loops[*i]));
      loops.erase(loops.begin() + ptrdiff_t(*i));
    }
  }
  return {};
}

// One round: what can be told from the handles as they are.
size_t RemoveSome(const RemoveHandlesOptions& options,
                  const Context& context,
                  std::set<Vertices>* refused,
                  IndexedMesh* mesh) {
  const HalfEdges half_edges(mesh->positions.size(), mesh->triangles, context);
  std::vector<HandleLoop> loops = FindHandleLoops(
      *mesh,
      half_edges,
      SurfaceHomology(half_edges, context),
      std::max(kTunnelLength * options.max_length, options.max_length_anywhere),
      context);
  std::erase_if(loops, [&](const HandleLoop& loop) {
    return !IsShort(*mesh, half_edges, loop, options);
  });
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    std::vector<HandleLoop> chosen =
        ChooseDisjoint(loops, half_edges, *refused);
    if (chosen.empty()) {
      break;
    }
    KeepConnected(half_edges, chosen);
    CutMesh cut = CutLoops(*mesh,
                           half_edges,
                           std::move(chosen),
                           options.min_height,
                           context,
                           refused);
    if (cut.num_loops > 0) {
      *mesh = std::move(cut.mesh);
      return cut.num_loops;
    }
  }
  return 0;
}

}  // namespace

RemovedHandles RemoveHandles(IndexedMesh mesh,
                             const RemoveHandlesOptions& options,
                             const Context& context) {
  RemovedHandles result;
  result.mesh = std::move(mesh);
  if (options.max_length <= 0) {
    return result;
  }
  const Phase phase(context, "removal of small handles");
  std::set<Vertices> refused;
  size_t num_removed;
  do {
    num_removed = RemoveSome(options, context, &refused, &result.mesh);
    result.summary.num_removed += num_removed;
  } while (num_removed > 0);
  result.summary.num_refused = refused.size();
  return result;
}

}  // namespace octacut
