#include "core/handles/handle_loops.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kLoopGrain = 64;

// The vertices around a source by their distance along edges.
class Ball {
 public:
  Ball(const IndexedMesh& mesh,
       const HalfEdges& half_edges,
       const SurfaceHomology& homology)
      : mesh_(mesh), half_edges_(half_edges), homology_(homology) {}

  // The shortest loop through `source` that does not separate, if there is one
  // of at most `max_length`; paths that share their beginning are cut to the
  // loop that they end in. Else without half-edges.
  HandleLoop ShortestLoop(uint32_t source, double max_length) {
    Grow(source, max_length / 2);
    HandleLoop loop;
    loop.length = std::numeric_limits<double>::infinity();
    uint32_t best = HalfEdges::kNone;
    for (const auto& [vertex, node] : nodes_) {
      for (const uint32_t h : half_edges_.Leaving(vertex)) {
        const auto other = nodes_.find(half_edges_.End(h));
        if (other == nodes_.end()) {
          continue;
        }
        const uint64_t homology_class = node.homology_class ^
                                        other->second.homology_class ^
                                        homology_.Class(h);
        const double length =
            node.distance + other->second.distance + Length(h);
        if (homology_class != 0 && length <= max_length &&
            std::tie(length, h) < std::tie(loop.length, best)) {
          loop.length = length;
          best = h;
        }
      }
    }
    if (best != HalfEdges::kNone) {
      Trace(best, loop);
    }
    return loop;
  }

 private:
  struct Node {
    double distance = 0;
    uint64_t homology_class = 0;
    uint32_t from = HalfEdges::kNone;  // half-edge by which it was reached
  };

  double Length(uint32_t h) const {
    return (mesh_.positions[half_edges_.End(h)] -
            mesh_.positions[half_edges_.Origin(h)])
        .norm();
  }

  // Dijkstra's algorithm; of equal paths the one by the lowest half-edge.
  void Grow(uint32_t source, double radius) {
    nodes_.clear();
    using Reached = std::tuple<double, uint32_t, uint32_t>;  // vertex, from
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    queue.emplace(0, source, HalfEdges::kNone);
    while (!queue.empty()) {
      const auto [distance, vertex, from] = queue.top();
      queue.pop();
      if (nodes_.contains(vertex)) {
        continue;
      }
      Node& node = nodes_[vertex];
      node.distance = distance;
      node.from = from;
      if (from != HalfEdges::kNone) {
        node.homology_class = nodes_[half_edges_.Origin(from)].homology_class ^
                              homology_.Class(from);
      }
      for (const uint32_t h : half_edges_.Leaving(vertex)) {
        const double further = distance + Length(h);
        if (further <= radius) {
          queue.emplace(further, half_edges_.End(h), h);
        }
      }
    }
  }

  // Half-edges from the source to `vertex`.
  std::vector<uint32_t> Path(uint32_t vertex) {
    std::vector<uint32_t> path;
    for (uint32_t h = nodes_[vertex].from; h != HalfEdges::kNone;
         h = nodes_[half_edges_.Origin(h)].from) {
      path.push_back(h);
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  void Trace(uint32_t closing, HandleLoop& loop) {
    const std::vector<uint32_t> there = Path(half_edges_.Origin(closing));
    const std::vector<uint32_t> back = Path(half_edges_.End(closing));
    size_t shared = 0;
    while (shared < there.size() && shared < back.size() &&
           there[shared] == back[shared]) {
      loop.length -= 2 * Length(there[shared++]);
    }
    loop.half_edges.assign(there.begin() + ptrdiff_t(shared), there.end());
    loop.half_edges.push_back(closing);
    for (size_t i = back.size(); i-- > shared;) {
      loop.half_edges.push_back(half_edges_.Opposite(back[i]));
    }
  }

  const IndexedMesh& mesh_;
  const HalfEdges& half_edges_;
  const SurfaceHomology& homology_;
  std::unordered_map<uint32_t, Node> nodes_;
};

}  // namespace

std::vector<HandleLoop> FindHandleLoops(const IndexedMesh& mesh,
                                        const HalfEdges& half_edges,
                                        const SurfaceHomology& homology,
                                        double max_length,
                                        const Context& context) {
  std::vector<uint32_t> sources = homology.CrossingHalfEdges();
  for (uint32_t& source : sources) {
    source = half_edges.Origin(source);
  }
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  std::vector<HandleLoop> loops(sources.size());
  ParallelFor(
      context, sources.size(), kLoopGrain, [&](size_t begin, size_t end) {
        Ball ball(mesh, half_edges, homology);
        for (size_t i = begin; i < end; ++i) {
          loops[i] = ball.ShortestLoop(sources[i], max_length);
        }
      });
  std::erase_if(loops,
                [](const HandleLoop& loop) { return loop.half_edges.empty(); });
  std::sort(loops.begin(), loops.end(), [](const auto& a, const auto& b) {
    return std::tie(a.length, a.half_edges) < std::tie(b.length, b.half_edges);
  });
  return loops;
}

}  // namespace octacut
