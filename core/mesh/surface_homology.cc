#include "core/mesh/surface_homology.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "core/base/error.h"

namespace octacut {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

using Triangles = std::span<const std::array<uint32_t, 3>>;

uint32_t Origin(Triangles triangles, uint32_t half_edge) {
  return triangles[half_edge / 3][half_edge % 3];
}

uint32_t End(Triangles triangles, uint32_t half_edge) {
  return triangles[half_edge / 3][(half_edge + 1) % 3];
}

}  // namespace

SurfaceHomology::SurfaceHomology(size_t num_vertices, Triangles triangles)
    : leaving_(FindVertexCorners(num_vertices, triangles)) {
  FindOpposites(triangles);
  const std::vector<uint8_t> in_tree = GrowTree(triangles);
  const std::vector<uint32_t> order = GrowCotree(in_tree);
  std::mt19937_64 random;  // of the same numbers each time
  words_.assign(triangles.size(), 0);
  for (uint32_t h = 0; h < opposite_.size(); ++h) {
    const uint32_t o = opposite_[h];
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
    if (h != kNone) {
      words_[opposite_[h] / 3] ^= words_[order[i]];
    }
  }
}

void SurfaceHomology::FindOpposites(Triangles triangles) {
  opposite_.resize(3 * triangles.size());
  for (uint32_t h = 0; h < opposite_.size(); ++h) {
    const std::span<const uint32_t> leaving = leaving_.Of(End(triangles, h));
    const auto opposite =
        std::find_if(leaving.begin(), leaving.end(), [&](uint32_t other) {
          return End(triangles, other) == Origin(triangles, h);
        });
    if (opposite == leaving.end()) {
      throw InvariantError(
          fmt::format("triangle {} has an edge without another one", h / 3));
    }
    opposite_[h] = *opposite;
  }
}

// A spanning tree of each component, breadth first: 1 for its half-edges.
std::vector<uint8_t> SurfaceHomology::GrowTree(Triangles triangles) const {
  std::vector<uint8_t> in_tree(opposite_.size());
  std::vector<uint8_t> is_reached(leaving_.offsets.size() - 1);
  std::vector<uint32_t> queue;
  queue.reserve(is_reached.size());
  for (uint32_t root = 0; root < is_reached.size(); ++root) {
    if (is_reached[root]) {
      continue;
    }
    is_reached[root] = 1;
    size_t next = queue.size();
    for (queue.push_back(root); next < queue.size(); ++next) {
      for (const uint32_t h : leaving_.Of(queue[next])) {
        const uint32_t end = End(triangles, h);
        if (!is_reached[end]) {
          is_reached[end] = 1;
          in_tree[h] = in_tree[opposite_[h]] = 1;
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
  const size_t num_triangles = opposite_.size() / 3;
  towards_root_.assign(num_triangles, kNone);
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
        const uint32_t o = opposite_[h];
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
  const uint32_t other = opposite_[half_edge];
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
    for (uint32_t h = 0; h < opposite_.size(); ++h) {
      if (h < opposite_[h] && Class(h) != 0) {
        crossing.push_back(h);
      }
    }
  }
  return crossing;
}

}  // namespace octacut
