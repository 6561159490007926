#include "core/handles/surface_homology.h"

#include <algorithm>
#include <random>

namespace octacut {

SurfaceHomology::SurfaceHomology(const HalfEdges& half_edges,
                                 const Context& context)
    : half_edges_(half_edges) {
  const std::vector<uint8_t> in_tree = GrowTree();
  context.ThrowIfCancelled();
  const std::vector<uint32_t> order = GrowCotree(in_tree);
  context.ThrowIfCancelled();
  std::mt19937_64 random;  // the same numbers each time
  words_.assign(order.size(), 0);
  for (uint32_t h = 0; h < half_edges.Size(); ++h) {
    const uint32_t o = half_edges.Opposite(h);
    if (h < o && !in_tree[h] && towards_root_[h / 3] != h &&
        towards_root_[o / 3] != o) {
      const uint64_t word = random();
      generators_.push_back({h, word});
      words_[h / 3] ^= word;
      words_[o / 3] ^= word;
    }
  }
  // Leaves first.
  for (size_t i = order.size(); i-- > 0;) {
    const uint32_t h = towards_root_[order[i]];
    if (h != HalfEdges::kNone) {
      words_[half_edges.Opposite(h) / 3] ^= words_[order[i]];
    }
  }
}

// A spanning tree of each component, breadth first: 1 for its half-edges.
std::vector<uint8_t> SurfaceHomology::GrowTree() const {
  std::vector<uint8_t> in_tree(half_edges_.Size());
  std::vector<uint8_t> is_reached(half_edges_.NumVertices());
  std::vector<uint32_t> queue;
  queue.reserve(is_reached.size());
  for (uint32_t root = 0; root < is_reached.size(); ++root) {
    if (is_reached[root]) {
      continue;
    }
    is_reached[root] = 1;
    size_t next = queue.size();
    for (queue.push_back(root); next < queue.size(); ++next) {
      for (const uint32_t h : half_edges_.Leaving(queue[next])) {
        const uint32_t end = half_edges_.End(h);
        if (!is_reached[end]) {
          is_reached[end] = 1;
          in_tree[h] = in_tree[half_edges_.Opposite(h)] = 1;
          queue.push_back(end);
        }
      }
    }
  }
  return in_tree;
}

// The same of the triangles, across no edge of the first tree. Returns the
// triangles in the order in which they were reached.
std::vector<uint32_t> SurfaceHomology::GrowCotree(
    const std::vector<uint8_t>& in_tree) {
  const uint32_t num_triangles = half_edges_.Size() / 3;
  towards_root_.assign(num_triangles, HalfEdges::kNone);
  std::vector<uint8_t> is_reached(num_triangles);
  std::vector<uint32_t> queue;
  queue.reserve(num_triangles);
  for (uint32_t root = 0; root < num_triangles; ++root) {
    if (is_reached[root]) {
      continue;
    }
    is_reached[root] = 1;
    size_t next = queue.size();
    for (queue.push_back(root); next < queue.size(); ++next) {
      for (uint32_t h = 3 * queue[next]; h < 3 * queue[next] + 3; ++h) {
        const uint32_t o = half_edges_.Opposite(h);
        if (!in_tree[h] && !is_reached[o / 3]) {
          is_reached[o / 3] = 1;
          towards_root_[o / 3] = o;
          queue.push_back(o / 3);
        }
      }
    }
  }
  return queue;
}

uint64_t SurfaceHomology::Class(uint32_t half_edge) const {
  const uint32_t other = half_edges_.Opposite(half_edge);
  if (towards_root_[half_edge / 3] == half_edge) {
    return words_[half_edge / 3];
  }
  if (towards_root_[other / 3] == other) {
    return words_[other / 3];
  }
  const uint32_t lower = std::min(half_edge, other);
  const auto generator = std::lower_bound(
      generators_.begin(),
      generators_.end(),
      lower,
      [](const Generator& g, uint32_t h) { return g.half_edge < h; });
  return generator != generators_.end() && generator->half_edge == lower
             ? generator->word
             : 0;
}

std::vector<uint32_t> SurfaceHomology::CrossingHalfEdges() const {
  std::vector<uint32_t> crossing;
  if (!generators_.empty()) {
    for (uint32_t h = 0; h < half_edges_.Size(); ++h) {
      if (h < half_edges_.Opposite(h) && Class(h) != 0) {
        crossing.push_back(h);
      }
    }
  }
  return crossing;
}

}  // namespace octacut
