#include "core/handles/handle_cutter.h"

#include <algorithm>
#include <numeric>

#include "core/mesh/self_intersections.h"
#include "core/mesh/thin_triangles.h"

namespace octacut {
namespace {

constexpr uint32_t kNoLoop = 0xffffffffu;
// How far both sides of a cut part: of the way to the vertices next to it.
constexpr double kParting = 0.25;

}  // namespace

HandleCutter::HandleCutter(const IndexedMesh& mesh, const HalfEdges& half_edges)
    : before_(mesh),
      half_edges_(half_edges),
      loop_of_vertex_(mesh.positions.size(), kNoLoop) {
  cut_.positions = mesh.positions;
  cut_.triangles = mesh.triangles;
}

void HandleCutter::Cut(const HandleLoop& loop) {
  const uint32_t first_copy = uint32_t(cut_.positions.size());
  const size_t size = loop.half_edges.size();
  cut_.positions.resize(first_copy + size);
  std::vector<uint32_t> left(size);
  std::vector<uint32_t> right(size);
  std::iota(right.begin(), right.end(), first_copy);
  for (size_t i = 0; i < size; ++i) {
    const uint32_t ahead = loop.half_edges[i];
    const uint32_t back =
        half_edges_.Opposite(loop.half_edges[(i + size - 1) % size]);
    const uint32_t vertex = half_edges_.Origin(ahead);
    left[i] = vertex;
    cut_.positions[vertex] = Parted(vertex, ahead, back);
    cut_.positions[right[i]] = Parted(vertex, back, ahead);
    for (uint32_t h = back; h != ahead; h = half_edges_.NextAround(h)) {
      cut_.triangles[h / 3][h % 3] = right[i];
    }
    loop_of_vertex_[vertex] = uint32_t(num_loops_);
  }
  std::reverse(left.begin(), left.end());
  Close(left);
  Close(right);
  loop_of_vertex_.resize(cut_.positions.size(), uint32_t(num_loops_));
  ++num_loops_;
}

std::set<size_t> HandleCutter::FindFailed(double min_height,
                                          const Context& context) const {
  std::vector<uint8_t> has_changed(cut_.triangles.size());
  std::set<size_t> failed;
  for (size_t t = 0; t < has_changed.size(); ++t) {
    const size_t loop = LoopOf(t);
    if (loop == num_loops_) {
      continue;
    }
    has_changed[t] = 1;
    if (IsThin(cut_.positions, cut_.triangles[t], min_height)) {
      failed.insert(loop);
    }
  }
  for (const auto& [a, b] :
       FindIntersectionsOfMarked(cut_, has_changed, context)) {
    const size_t first = std::min(LoopOf(a), LoopOf(b));
    const size_t second = std::max(LoopOf(a), LoopOf(b));
    failed.insert(second == num_loops_ ? first : second);
  }
  return failed;
}

// A vertex on its way to the mean of its neighbours between two half-edges.
Eigen::Vector3d HandleCutter::Parted(uint32_t vertex,
                                     uint32_t from,
                                     uint32_t to) const {
  const Eigen::Vector3d& position = before_.positions[vertex];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (uint32_t h = half_edges_.NextAround(from); h != to;
       h = half_edges_.NextAround(h)) {
    sum += before_.positions[half_edges_.End(h)] - position;
    ++count;
  }
  return count == 0 ? position
                    : Eigen::Vector3d(position + kParting / count * sum);
}

// Counter-clockwise seen from outside.
void HandleCutter::Close(const std::vector<uint32_t>& border) {
  const uint32_t center = uint32_t(cut_.positions.size());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < border.size(); ++i) {
    sum += cut_.positions[border[i]];
    cut_.triangles.push_back(
        {border[i], border[(i + 1) % border.size()], center});
  }
  cut_.positions.push_back(sum / double(border.size()));
}

size_t HandleCutter::LoopOf(size_t triangle) const {
  for (const uint32_t v : cut_.triangles[triangle]) {
    if (loop_of_vertex_[v] != kNoLoop) {
      return loop_of_vertex_[v];
    }
  }
  return num_loops_;
}

}  // namespace octacut
