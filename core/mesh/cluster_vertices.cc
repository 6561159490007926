#include "core/mesh/cluster_vertices.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>
#include <unordered_map>

#include "core/base/error.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {
namespace {

constexpr uint32_t kUnused = std::numeric_limits<uint32_t>::max();
// Keys of cells hold 21 bits for each axis.
constexpr double kMaxCells = (1 << 21) - 2;
// Eigenvalues below this share of the largest one mean that the planes of a
// cell leave a direction open (Lindstrom 2000).
constexpr double kLeastEigenvalue = 1e-3;

using Triangle = std::array<uint32_t, 3>;

void RequireFinite(const IndexedMesh& mesh) {
  for (const Triangle& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      if (!mesh.positions[corner].allFinite()) {
        throw InputError("simplification: coordinates are not finite");
      }
    }
  }
}

struct CellGrid {
  Eigen::Vector3d origin;
  double edge;

  Eigen::Vector3d Coordinates(const Eigen::Vector3d& point) const {
    return ((point - origin) / edge).array().floor();
  }
  uint64_t Key(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d cell = Coordinates(point);
    return uint64_t(cell.x()) | uint64_t(cell.y()) << 21 |
           uint64_t(cell.z()) << 42;
  }
};

bool IsWhole(uint64_t a, uint64_t b, uint64_t c) {
  return a != b && b != c && c != a;
}

size_t CountWhole(const IndexedMesh& mesh, const CellGrid& grid) {
  std::vector<uint64_t> keys(mesh.positions.size());
  std::vector<bool> known(mesh.positions.size());
  const auto key_of = [&](uint32_t vertex) {
    if (!known[vertex]) {
      keys[vertex] = grid.Key(mesh.positions[vertex]);
      known[vertex] = true;
    }
    return keys[vertex];
  };
  size_t count = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    count += IsWhole(key_of(a), key_of(b), key_of(c));
  }
  return count;
}

// The finest grid that keeps at most `max_triangles`, to a per cent.
CellGrid ChooseGrid(const IndexedMesh& mesh,
                    const Eigen::AlignedBox3d& box,
                    size_t max_triangles,
                    const Context& context) {
  const double size = box.sizes().maxCoeff();
  const Eigen::Vector3d& origin = box.min();
  double fine = size / kMaxCells;
  double coarse = size;  // a single cell keeps no triangle
  while (coarse > 1.01 * fine) {
    context.ThrowIfCancelled();
    const double middle = std::sqrt(fine * coarse);
    const bool fits = CountWhole(mesh, {origin, middle}) <= max_triangles;
    (fits ? coarse : fine) = middle;
  }
  return {origin, coarse};
}

// The sum of squared distances to planes, relative to a point near them.
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

class Clustering {
 public:
  Clustering(const IndexedMesh& mesh, const CellGrid& grid)
      : mesh_(mesh), grid_(grid), cluster_of_(mesh.positions.size(), kUnused) {
    Assign();
    AddQuadrics();
  }

  ClusteredMesh Result() {
    ClusteredMesh result;
    result.is_simplified = true;
    result.mesh.positions.reserve(means_.size());
    for (size_t i = 0; i < means_.size(); ++i) {
      result.mesh.positions.push_back(Place(i));
    }
    result.mesh.triangles = WholeTriangles();
    result.sources = Nearest(result.mesh.positions);
    return result;
  }

 private:
  // Clusters in the order of the triangles, with the means of their vertices.
  void Assign() {
    std::unordered_map<uint64_t, uint32_t> cluster_at;
    std::vector<double> counts;
    for (const Triangle& triangle : mesh_.triangles) {
      for (const uint32_t vertex : triangle) {
        if (cluster_of_[vertex] != kUnused) {
          continue;
        }
        const auto [entry, is_new] =
            cluster_at.try_emplace(grid_.Key(mesh_.positions[vertex]),
                                   static_cast<uint32_t>(means_.size()));
        if (is_new) {
          means_.emplace_back(Eigen::Vector3d::Zero());
          counts.push_back(0);
        }
        cluster_of_[vertex] = entry->second;
        means_[entry->second] += mesh_.positions[vertex];
        ++counts[entry->second];
      }
    }
    for (size_t i = 0; i < means_.size(); ++i) {
      means_[i] /= counts[i];
    }
  }

  void AddQuadrics() {
    quadrics_.resize(means_.size());
    for (const auto& triangle : mesh_.triangles) {
      // Weighted by the square of the area.
      const Eigen::Vector3d normal = AreaNormal(mesh_, triangle);
      for (const uint32_t corner : triangle) {
        const uint32_t cluster = cluster_of_[corner];
        Quadric& quadric = quadrics_[cluster];
        quadric.a += normal * normal.transpose();
        quadric.b +=
            normal * normal.dot(mesh_.positions[triangle[0]] - means_[cluster]);
      }
    }
  }

  Eigen::Vector3d Place(size_t cluster) const {
    const Eigen::Vector3d& mean = means_[cluster];
    const Quadric& quadric = quadrics_[cluster];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(quadric.a);
    const Eigen::Vector3d& values = solver.eigenvalues();
    if (!(values[2] > 0)) {
      return mean;
    }
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      if (values[i] > kLeastEigenvalue * values[2]) {
        const Eigen::Vector3d axis = solver.eigenvectors().col(i);
        step += axis * (axis.dot(quadric.b) / values[i]);
      }
    }
    const Eigen::Vector3d place = mean + step;
    const Eigen::Vector3d low =
        grid_.origin + grid_.edge * grid_.Coordinates(mean);
    return place.cwiseMax(low).cwiseMin(low +
                                        Eigen::Vector3d::Constant(grid_.edge));
  }

  // Each triangle of clusters once; of two sides that fell together, both.
  std::vector<Triangle> WholeTriangles() const {
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c] : mesh_.triangles) {
      Triangle whole = {cluster_of_[a], cluster_of_[b], cluster_of_[c]};
      if (IsWhole(whole[0], whole[1], whole[2])) {
        std::rotate(whole.begin(),
                    std::min_element(whole.begin(), whole.end()),
                    whole.end());
        triangles.push_back(whole);
      }
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()),
                    triangles.end());
    return triangles;
  }

  std::vector<uint32_t> Nearest(
      const std::vector<Eigen::Vector3d>& positions) const {
    std::vector<uint32_t> nearest(positions.size());
    std::vector<double> least(positions.size(),
                              std::numeric_limits<double>::infinity());
    for (uint32_t vertex = 0; vertex < cluster_of_.size(); ++vertex) {
      const uint32_t cluster = cluster_of_[vertex];
      if (cluster == kUnused) {
        continue;
      }
      const double distance =
          (mesh_.positions[vertex] - positions[cluster]).squaredNorm();
      if (distance < least[cluster]) {
        least[cluster] = distance;
        nearest[cluster] = vertex;
      }
    }
    return nearest;
  }

  const IndexedMesh& mesh_;
  const CellGrid& grid_;
  std::vector<uint32_t> cluster_of_;
  std::vector<Eigen::Vector3d> means_;
  std::vector<Quadric> quadrics_;
};

ClusteredMesh WithoutUnusedVertices(const IndexedMesh& mesh) {
  ClusteredMesh result;
  std::vector<uint32_t> new_index(mesh.positions.size(), kUnused);
  for (Triangle triangle : mesh.triangles) {
    for (uint32_t& corner : triangle) {
      uint32_t& index = new_index[corner];
      if (index == kUnused) {
        index = static_cast<uint32_t>(result.sources.size());
        result.sources.push_back(corner);
        result.mesh.positions.push_back(mesh.positions[corner]);
      }
      corner = index;
    }
    result.mesh.triangles.push_back(triangle);
  }
  return result;
}

ClusteredMesh Cluster(const IndexedMesh& mesh,
                      const Eigen::AlignedBox3d& box,
                      size_t max_triangles,
                      const Context& context) {
  const ClusteredMesh clusters =
      Clustering(mesh, ChooseGrid(mesh, box, max_triangles, context)).Result();
  ClusteredMesh used = WithoutUnusedVertices(clusters.mesh);
  for (uint32_t& source : used.sources) {
    source = clusters.sources[source];
  }
  used.is_simplified = true;
  return used;
}

}  // namespace

ClusteredMesh ClusterVertices(const IndexedMesh& mesh,
                              size_t max_triangles,
                              const Context& context) {
  if (mesh.triangles.empty()) {
    throw InputError("simplification: the mesh has no triangles");
  }
  RequireFinite(mesh);
  const Eigen::AlignedBox3d box = BoxOfTriangles(mesh);
  if (mesh.triangles.size() <= max_triangles) {
    ClusteredMesh whole = WithoutUnusedVertices(mesh);
    if (whole.mesh.positions.size() <= max_triangles) {
      return whole;
    }
  }
  if (!(box.sizes().maxCoeff() > 0)) {
    throw InputError("simplification: all triangles are at one point");
  }
  ClusteredMesh result = Cluster(mesh, box, max_triangles, context);
  if (result.mesh.positions.size() > max_triangles) {
    // Triangles that share no vertices have three each.
    result = Cluster(mesh, box, max_triangles / 3, context);
  }
  return result;
}

}  // namespace octacut
