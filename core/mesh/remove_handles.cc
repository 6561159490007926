#include "core/mesh/remove_handles.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "core/mesh/handle_loops.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/surface_homology.h"
#include "core/mesh/triangle_intersection.h"

namespace octacut {
namespace {

constexpr uint32_t kNone = 0xffffffffu;
// How far both sides of a cut part: of the way to the vertices next to it.
constexpr double kParting = 0.25;

using Vertices = std::vector<uint32_t>;

// In the order of the loop.
Vertices VerticesOf(const IndexedMesh& mesh, const HandleLoop& loop) {
  Vertices vertices;
  for (const uint32_t h : loop.half_edges) {
    vertices.push_back(mesh.triangles[h / 3][h % 3]);
  }
  return vertices;
}

// Words of which none is the exclusive or of others.
class IndependentWords {
 public:
  // Whether `word` is independent of those that were added.
  bool Add(uint64_t word) {
    for (const uint64_t reduced : words_) {
      word = std::min(word, word ^ reduced);
    }
    if (word == 0) {
      return false;
    }
    words_.push_back(word);
    std::sort(words_.begin(), words_.end(), std::greater<>());
    return true;
  }

 private:
  std::vector<uint64_t> words_;  // each with its own highest bit, descending
};

// Loops that no triangle touches two of, and that together do not separate.
std::vector<HandleLoop> ChooseLoops(const IndexedMesh& mesh,
                                    const SurfaceHomology& homology,
                                    const std::vector<HandleLoop>& loops,
                                    const std::set<Vertices>& refused) {
  std::vector<uint8_t> is_near(mesh.positions.size());
  IndependentWords words;
  std::vector<HandleLoop> chosen;
  for (const HandleLoop& loop : loops) {
    const Vertices vertices = VerticesOf(mesh, loop);
    if (std::any_of(vertices.begin(),
                    vertices.end(),
                    [&](uint32_t v) { return is_near[v] != 0; }) ||
        refused.contains(vertices) || !words.Add(loop.homology_class)) {
      continue;
    }
    chosen.push_back(loop);
    for (const uint32_t v : vertices) {
      for (const uint32_t h : homology.Leaving().Of(v)) {
        is_near[mesh.triangles[h / 3][(h + 1) % 3]] = 1;
      }
    }
  }
  return chosen;
}

// Cuts a mesh along loops and closes both sides by fans.
class HandleCutter {
 public:
  HandleCutter(const IndexedMesh& mesh, const SurfaceHomology& homology)
      : before_(mesh), homology_(homology) {
    cut_.positions = mesh.positions;
    cut_.triangles = mesh.triangles;
    loop_of_vertex_.assign(mesh.positions.size(), kNone);
  }

  void Cut(const HandleLoop& loop) {
    const Vertices vertices = VerticesOf(before_, loop);
    const uint32_t first_copy = uint32_t(cut_.positions.size());
    const size_t size = vertices.size();
    cut_.positions.resize(first_copy + size);
    for (size_t i = 0; i < size; ++i) {
      const uint32_t towards = loop.half_edges[i];
      const uint32_t back =
          homology_.Opposite(loop.half_edges[(i + size - 1) % size]);
      const Eigen::Vector3d left = Parted(vertices[i], towards, back);
      const Eigen::Vector3d right = Parted(vertices[i], back, towards);
      const uint32_t copy = first_copy + uint32_t(i);
      cut_.positions[vertices[i]] = left;
      cut_.positions[copy] = right;
      for (uint32_t h = back; h != towards; h = Next(h)) {
        cut_.triangles[h / 3][h % 3] = copy;
      }
    }
    Close({vertices.rbegin(), vertices.rend()});
    Vertices copies(size);
    std::iota(copies.begin(), copies.end(), first_copy);
    Close(copies);
    loop_of_vertex_.resize(cut_.positions.size(), num_loops_);
    for (const uint32_t v : vertices) {
      loop_of_vertex_[v] = num_loops_;
    }
    ++num_loops_;
  }

  // Loops, by the order of their cuts, whose triangles are degenerate or run
  // through others.
  std::set<uint32_t> FindFailed(const Context& context) const {
    std::vector<uint8_t> has_changed(cut_.triangles.size());
    std::set<uint32_t> failed;
    for (size_t t = 0; t < has_changed.size(); ++t) {
      has_changed[t] = IsTouched(uint32_t(t)) ? 1 : 0;
      const auto& [a, b, c] = cut_.triangles[t];
      if (has_changed[t] &&
          IsDegenerate(
              {cut_.positions[a], cut_.positions[b], cut_.positions[c]})) {
        AddLoops(uint32_t(t), failed);
      }
    }
    for (const auto& pair :
         FindIntersectionsOfMarked(cut_, has_changed, context)) {
      AddLoops(pair[0], failed);
      AddLoops(pair[1], failed);
    }
    return failed;
  }

  IndexedMesh TakeMesh() { return std::move(cut_); }

 private:
  // The next half-edge around its origin, counter-clockwise.
  uint32_t Next(uint32_t h) const {
    return homology_.Opposite(3 * (h / 3) + (h + 2) % 3);
  }

  // A vertex on its way to the mean of its neighbours between two half-edges.
  Eigen::Vector3d Parted(uint32_t vertex, uint32_t from, uint32_t to) const {
    const Eigen::Vector3d& position = before_.positions[vertex];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (uint32_t h = Next(from); h != to; h = Next(h)) {
      sum +=
          before_.positions[before_.triangles[h / 3][(h + 1) % 3]] - position;
      ++count;
    }
    return count == 0 ? position
                      : Eigen::Vector3d(position + kParting / count * sum);
  }

  // Counter-clockwise seen from outside.
  void Close(const Vertices& border) {
    const uint32_t center = uint32_t(cut_.positions.size());
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (size_t i = 0; i < border.size(); ++i) {
      sum += cut_.positions[border[i]];
      cut_.triangles.push_back(
          {border[i], border[(i + 1) % border.size()], center});
    }
    cut_.positions.push_back(sum / double(border.size()));
  }

  bool IsTouched(uint32_t triangle) const {
    const auto& corners = cut_.triangles[triangle];
    return std::any_of(corners.begin(), corners.end(), [&](uint32_t v) {
      return loop_of_vertex_[v] != kNone;
    });
  }

  void AddLoops(uint32_t triangle, std::set<uint32_t>& loops) const {
    for (const uint32_t v : cut_.triangles[triangle]) {
      if (loop_of_vertex_[v] != kNone) {
        loops.insert(loop_of_vertex_[v]);
      }
    }
  }

  const IndexedMesh& before_;
  const SurfaceHomology& homology_;
  IndexedMesh cut_;
  std::vector<uint32_t> loop_of_vertex_;  // kNone: of none
  uint32_t num_loops_ = 0;
};

}  // namespace

MeshWithoutHandles RemoveHandles(IndexedMesh mesh,
                                 double max_length,
                                 const Context& context) {
  MeshWithoutHandles result;
  result.mesh = std::move(mesh);
  std::set<Vertices> refused;
  bool has_changed = max_length > 0;
  while (has_changed) {
    has_changed = false;
    const SurfaceHomology homology(result.mesh.positions.size(),
                                   result.mesh.triangles);
    const std::vector<HandleLoop> loops =
        FindHandleLoops(result.mesh, homology, max_length, context);
    while (!has_changed) {
      const std::vector<HandleLoop> chosen =
          ChooseLoops(result.mesh, homology, loops, refused);
      if (chosen.empty()) {
        break;
      }
      HandleCutter cutter(result.mesh, homology);
      for (const HandleLoop& loop : chosen) {
        cutter.Cut(loop);
      }
      const std::set<uint32_t> failed = cutter.FindFailed(context);
      for (const uint32_t i : failed) {
        refused.insert(VerticesOf(result.mesh, chosen[i]));
      }
      if (failed.empty()) {
        result.mesh = cutter.TakeMesh();
        result.summary.num_removed += chosen.size();
        has_changed = true;
      }
    }
  }
  result.summary.num_refused = refused.size();
  return result;
}

}  // namespace octacut
