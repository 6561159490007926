#include "core/mesh/self_intersections.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/triangle_intersection.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 4096;

TriangleCorners CornersOf(const IndexedMesh& mesh, uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

void CheckIndices(const IndexedMesh& mesh) {
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const uint32_t vertex : mesh.triangles[i]) {
      if (vertex >= mesh.positions.size()) {
        throw InputError(
            fmt::format("triangle {}: vertex index {} is out of range, there "
                        "are {} vertices",
                        i,
                        vertex,
                        mesh.positions.size()));
      }
    }
  }
}

// 1 for triangles with finite corners and an area.
std::vector<uint8_t> MarkUsable(const IndexedMesh& mesh,
                                const Context& context) {
  std::vector<uint8_t> used(mesh.triangles.size());
  ParallelFor(context, used.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const TriangleCorners corners = CornersOf(mesh, static_cast<uint32_t>(i));
      const bool is_finite = corners[0].allFinite() && corners[1].allFinite() &&
                             corners[2].allFinite();
      used[i] = is_finite && !IsDegenerate(corners);
    }
  });
  return used;
}

struct Found {
  size_t num_pairs = 0;
  std::vector<std::array<uint32_t, 2>> examples;
};

}  // namespace

SelfIntersections FindSelfIntersections(const IndexedMesh& mesh,
                                        const Context& context,
                                        size_t max_examples) {
  CheckIndices(mesh);
  const std::vector<uint8_t> used = MarkUsable(mesh, context);
  const BoxTree tree(mesh, used, context);
  Phase phase(context, "self-intersections", tree.NumLeaves());
  std::vector<uint8_t> is_hit(mesh.triangles.size());
  // The same mark from any thread, so that order does not matter.
  const auto mark = [&](uint32_t triangle) {
    std::atomic_ref<uint8_t>(is_hit[triangle])
        .store(1, std::memory_order_relaxed);
  };
  std::vector<Found> chunks(NumChunks(tree.NumLeaves(), kGrain));
  ParallelChunks(
      context,
      tree.NumLeaves(),
      kGrain,
      [&](size_t chunk, size_t begin, size_t end) {
        Found& found = chunks[chunk];
        for (size_t leaf = begin; leaf < end; ++leaf) {
          const uint32_t triangle = tree.Triangle(leaf);
          const TriangleCorners corners = CornersOf(mesh, triangle);
          tree.ForLaterNeighbors(leaf, [&](size_t other_leaf) {
            const uint32_t other = tree.Triangle(other_leaf);
            if (!TrianglesIntersect(corners, CornersOf(mesh, other))) {
              return;
            }
            ++found.num_pairs;
            mark(triangle);
            mark(other);
            if (found.examples.size() < max_examples) {
              found.examples.push_back(
                  {std::min(triangle, other), std::max(triangle, other)});
            }
          });
        }
        phase.Advance(end - begin);
      });
  SelfIntersections result;
  for (const Found& found : chunks) {
    result.num_pairs += found.num_pairs;
    const size_t room = max_examples - result.examples.size();
    result.examples.insert(
        result.examples.end(),
        found.examples.begin(),
        found.examples.begin() +
            static_cast<std::ptrdiff_t>(std::min(room, found.examples.size())));
  }
  std::sort(result.examples.begin(), result.examples.end());
  result.num_triangles =
      static_cast<size_t>(std::count(is_hit.begin(), is_hit.end(), 1));
  result.num_left_out =
      static_cast<size_t>(std::count(used.begin(), used.end(), 0));
  return result;
}

std::vector<std::array<uint32_t, 2>> FindIntersectionsOfMarked(
    const IndexedMesh& mesh,
    const std::vector<uint8_t>& marked,
    const Context& context) {
  CheckIndices(mesh);
  const std::vector<uint8_t> usable = MarkUsable(mesh, context);
  std::vector<uint8_t> in_tree = usable;
  for (size_t i = 0; i < in_tree.size(); ++i) {
    in_tree[i] &= marked[i] != 0 ? 1 : 0;
  }
  const BoxTree tree(mesh, in_tree, context);
  std::vector<std::vector<std::array<uint32_t, 2>>> chunks(
      NumChunks(usable.size(), kGrain));
  ParallelChunks(
      context,
      usable.size(),
      kGrain,
      [&](size_t chunk, size_t begin, size_t end) {
        for (uint32_t triangle = uint32_t(begin); triangle < end; ++triangle) {
          if (!usable[triangle]) {
            continue;
          }
          const TriangleCorners corners = CornersOf(mesh, triangle);
          tree.ForTouching(mesh, triangle, [&](size_t leaf) {
            const uint32_t other = tree.Triangle(leaf);
            // Of two that are marked the smaller finds the pair.
            if (other == triangle || (marked[triangle] && other < triangle) ||
                !TrianglesIntersect(corners, CornersOf(mesh, other))) {
              return;
            }
            chunks[chunk].push_back(
                {std::min(triangle, other), std::max(triangle, other)});
          });
        }
      });
  std::vector<std::array<uint32_t, 2>> pairs;
  for (const auto& chunk : chunks) {
    pairs.insert(pairs.end(), chunk.begin(), chunk.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace octacut
