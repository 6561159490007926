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

constexpr size_t kPairGrain = 4096;

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

bool IsFinite(const TriangleCorners& corners) {
  return corners[0].allFinite() && corners[1].allFinite() &&
         corners[2].allFinite();
}

// 1 for triangles among `marked` with finite corners and an area.
std::vector<uint8_t> MarkUsable(const IndexedMesh& mesh,
                                std::vector<uint8_t> marked,
                                const Context& context) {
  ParallelEach(context, marked.size(), kPairGrain, [&](size_t i) {
    if (marked[i] != 0) {
      const TriangleCorners corners = CornersOf(mesh, static_cast<uint32_t>(i));
      marked[i] = IsFinite(corners) && !IsDegenerate(corners);
    }
  });
  return marked;
}

using TrianglePair = std::array<uint32_t, 2>;

TrianglePair Ordered(uint32_t one, uint32_t other) {
  return {std::min(one, other), std::max(one, other)};
}

struct Found {
  size_t num_pairs = 0;
  std::vector<TrianglePair> examples;
};

// Calls visit(triangle, other) for what the leaves from `begin` to `end`
// intersect of those after them.
template <typename Visit>
void VisitPairs(const IndexedMesh& mesh,
                const BoxTree& tree,
                size_t begin,
                size_t end,
                const Visit& visit) {
  tree.ForPairs(begin, end, [&](size_t leaf, size_t other_leaf) {
    const uint32_t triangle = tree.Triangle(leaf);
    const uint32_t other = tree.Triangle(other_leaf);
    if (TrianglesIntersect(CornersOf(mesh, triangle), CornersOf(mesh, other))) {
      visit(triangle, other);
    }
  });
}

// Appends what find(begin, end, found) finds, in order.
template <typename Find>
void AddFound(size_t count,
              const Find& find,
              const Context& context,
              std::vector<TrianglePair>* pairs) {
  std::vector<std::vector<TrianglePair>> chunks(NumChunks(count, kPairGrain));
  ParallelChunks(
      context, count, kPairGrain, [&](size_t chunk, size_t begin, size_t end) {
        find(begin, end, &chunks[chunk]);
      });
  for (const auto& chunk : chunks) {
    pairs->insert(pairs->end(), chunk.begin(), chunk.end());
  }
}

void AddPairsInTree(const IndexedMesh& mesh,
                    const BoxTree& tree,
                    const Context& context,
                    std::vector<TrianglePair>* pairs) {
  const auto find = [&](size_t begin,
                        size_t end,
                        std::vector<TrianglePair>* found) {
    VisitPairs(mesh, tree, begin, end, [&](uint32_t triangle, uint32_t other) {
      found->push_back(Ordered(triangle, other));
    });
  };
  AddFound(tree.NumLeaves(), find, context, pairs);
}

// Adds the pairs of triangles in the tree with others that are not `marked`.
void AddPairsWithUnmarked(const IndexedMesh& mesh,
                          const BoxTree& tree,
                          const std::vector<uint8_t>& marked,
                          const Context& context,
                          std::vector<TrianglePair>* pairs) {
  const auto find =
      [&](size_t begin, size_t end, std::vector<TrianglePair>* found) {
        for (auto triangle = static_cast<uint32_t>(begin); triangle < end;
             ++triangle) {
          const TriangleCorners corners = CornersOf(mesh, triangle);
          if (marked[triangle] != 0 || !IsFinite(corners)) {
            continue;
          }
          tree.ForTouching(mesh, triangle, [&](size_t leaf) {
            const uint32_t other = tree.Triangle(leaf);
            if (!IsDegenerate(corners) &&
                TrianglesIntersect(corners, CornersOf(mesh, other))) {
              found->push_back(Ordered(triangle, other));
            }
          });
        }
      };
  AddFound(marked.size(), find, context, pairs);
}

}  // namespace

SelfIntersections FindSelfIntersections(const IndexedMesh& mesh,
                                        const Context& context,
                                        size_t max_examples) {
  CheckIndices(mesh);
  const std::vector<uint8_t> used =
      MarkUsable(mesh, std::vector<uint8_t>(mesh.triangles.size(), 1), context);
  const BoxTree tree(mesh, used, context);
  Phase phase(context, "self-intersections", tree.NumLeaves());
  std::vector<uint8_t> is_hit(mesh.triangles.size());
  // The same mark from any thread, so that order does not matter.
  const auto mark = [&](uint32_t triangle) {
    std::atomic_ref<uint8_t>(is_hit[triangle])
        .store(1, std::memory_order_relaxed);
  };
  std::vector<Found> chunks(NumChunks(tree.NumLeaves(), kPairGrain));
  ParallelChunks(
      context,
      tree.NumLeaves(),
      kPairGrain,
      [&](size_t chunk, size_t begin, size_t end) {
        Found& found = chunks[chunk];
        VisitPairs(
            mesh, tree, begin, end, [&](uint32_t triangle, uint32_t other) {
              ++found.num_pairs;
              mark(triangle);
              mark(other);
              if (found.examples.size() < max_examples) {
                found.examples.push_back(Ordered(triangle, other));
              }
            });
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
  const BoxTree tree(mesh, MarkUsable(mesh, marked, context), context);
  std::vector<TrianglePair> pairs;
  AddPairsInTree(mesh, tree, context, &pairs);
  AddPairsWithUnmarked(mesh, tree, marked, context, &pairs);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace octacut
