#include "core/refine/surface_places.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace octacut {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

// Places with the vertices that are closest to them.
void Spread(const IndexedMesh& mesh,
            const VertexCorners& neighbors,
            double distance,
            SurfacePlaces* places) {
  const size_t count = mesh.positions.size();
  std::vector<double> closest(count, std::numeric_limits<double>::infinity());
  std::vector<uint32_t> found_by(count, kNone);
  std::vector<uint32_t> found;
  places->place_of.assign(count, kNone);
  for (uint32_t vertex = 0; vertex < count; ++vertex) {
    if (places->place_of[vertex] != kNone) {
      continue;
    }
    const uint32_t place = uint32_t(places->vertices.size());
    places->vertices.push_back(vertex);
    found.assign(1, vertex);
    found_by[vertex] = vertex;
    for (size_t i = 0; i < found.size(); ++i) {
      const double squared =
          (mesh.positions[found[i]] - mesh.positions[vertex]).squaredNorm();
      if (i > 0 && squared > distance * distance) {
        continue;
      }
      if (squared < closest[found[i]]) {
        closest[found[i]] = squared;
        places->place_of[found[i]] = place;
      }
      for (const uint32_t next : neighbors.Of(found[i])) {
        if (found_by[next] != vertex) {
          found_by[next] = vertex;
          found.push_back(next);
        }
      }
    }
  }
}

VertexCorners JoinPlaces(const VertexCorners& neighbors,
                         const std::vector<uint32_t>& place_of,
                         size_t num_places) {
  std::vector<std::pair<uint32_t, uint32_t>> joints;
  for (size_t v = 0; v < place_of.size(); ++v) {
    for (const uint32_t next : neighbors.Of(v)) {
      if (place_of[v] != place_of[next]) {
        joints.emplace_back(place_of[v], place_of[next]);
      }
    }
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  VertexCorners result;
  result.offsets.assign(num_places + 1, 0);
  for (const auto& [from, to] : joints) {
    ++result.offsets[from + 1];
    result.corners.push_back(to);
  }
  for (size_t place = 0; place < num_places; ++place) {
    result.offsets[place + 1] += result.offsets[place];
  }
  return result;
}

}  // namespace

SurfacePlaces SpreadPlaces(const IndexedMesh& mesh,
                           const VertexCorners& neighbors,
                           double distance) {
  SurfacePlaces places;
  Spread(mesh, neighbors, distance, &places);
  places.neighbors =
      JoinPlaces(neighbors, places.place_of, places.vertices.size());
  return places;
}

}  // namespace octacut
