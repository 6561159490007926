#include "core/mesh/audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/disjoint_sets.h"
#include "core/mesh/mesh_components.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {
namespace {

using Triangle = std::array<uint32_t, 3>;

constexpr size_t kAuditGrain = 1 << 15;
constexpr double kRelativeHeight = 1e-10;

bool HasRepeatedIndex(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// The triangles around one vertex, one after another.
class VertexAuditor {
 public:
  // Counts what belongs to `vertex`: the vertex itself, and the edges and
  // triangles of which it is the lowest index.
  void Audit(const std::vector<Triangle>& triangles,
             std::span<const uint32_t> corners,
             uint32_t vertex,
             MeshAudit& audit) {
    Collect(triangles, corners);
    if (links_.empty()) {
      return;
    }
    bool manifold = CountUmbrellas() == 1;
    for (size_t begin = 0, end = 0; begin < spokes_.size(); begin = end) {
      int outgoing = 0;
      for (end = begin; end < spokes_.size() &&
                        spokes_[end].neighbor == spokes_[begin].neighbor;
           ++end) {
        outgoing += spokes_[end].outgoing;
      }
      const size_t count = end - begin;
      manifold &= count <= 2;
      if (spokes_[begin].neighbor > vertex) {
        ++audit.num_edges;
        audit.num_boundary_edges += count == 1;
        audit.num_nonmanifold_edges += count > 2;
        audit.num_misoriented_edges += count == 2 && outgoing != 1;
      }
    }
    audit.num_nonmanifold_vertices += !manifold;
    audit.num_duplicate_triangles += CountDuplicates(vertex);
  }

 private:
  // The side of a triangle between the vertex and a neighbour.
  struct Spoke {
    uint32_t neighbor;
    uint32_t link;  // of links_
    bool outgoing;  // the triangle runs from the vertex to the neighbour
  };

  void Collect(const std::vector<Triangle>& triangles,
               std::span<const uint32_t> corners) {
    links_.clear();
    spokes_.clear();
    for (const uint32_t corner : corners) {
      const Triangle& triangle = triangles[corner / 3];
      const uint32_t i = corner % 3;
      const uint32_t next = triangle[(i + 1) % 3];
      const uint32_t previous = triangle[(i + 2) % 3];
      const uint32_t link = uint32_t(links_.size());
      links_.push_back({next, previous});
      spokes_.push_back({next, link, true});
      spokes_.push_back({previous, link, false});
    }
    std::sort(
        spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
          return a.neighbor != b.neighbor ? a.neighbor < b.neighbor
                                          : a.link < b.link;
        });
  }

  // Sets of triangles that hang together through edges at the vertex.
  size_t CountUmbrellas() {
    umbrellas_.Reset(links_.size());
    size_t count = links_.size();
    for (size_t i = 1; i < spokes_.size(); ++i) {
      if (spokes_[i].neighbor == spokes_[i - 1].neighbor) {
        count -= umbrellas_.Unite(spokes_[i].link, spokes_[i - 1].link);
      }
    }
    return count;
  }

  size_t CountDuplicates(uint32_t vertex) {
    std::erase_if(links_, [&](std::array<uint32_t, 2>& link) {
      std::sort(link.begin(), link.end());
      return link[0] < vertex;
    });
    std::sort(links_.begin(), links_.end());
    size_t count = 0;
    for (size_t i = 1; i < links_.size(); ++i) {
      count += links_[i] == links_[i - 1];
    }
    return count;
  }

  std::vector<std::array<uint32_t, 2>> links_;
  std::vector<Spoke> spokes_;
  DisjointSets umbrellas_;
};

// Sums of one chunk of triangles.
struct TriangleSums {
  double area = 0;
  double volume = 0;
  size_t num_flat = 0;
};

TriangleSums MeasureTriangles(const IndexedMesh& mesh,
                              const std::vector<Triangle>& triangles,
                              const Eigen::Vector3d& origin,
                              size_t begin,
                              size_t end) {
  TriangleSums sums;
  for (size_t t = begin; t < end; ++t) {
    const Eigen::Vector3d a = mesh.positions[triangles[t][0]] - origin;
    const Eigen::Vector3d b = mesh.positions[triangles[t][1]] - origin;
    const Eigen::Vector3d c = mesh.positions[triangles[t][2]] - origin;
    const double twice_area = (b - a).cross(c - a).norm();
    const double longest = std::max(
        {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    sums.num_flat += !(twice_area > kRelativeHeight * longest);
    sums.area += twice_area / 2;
    sums.volume += a.dot(b.cross(c)) / 6;
  }
  return sums;
}

void Measure(const IndexedMesh& mesh,
             const std::vector<Triangle>& triangles,
             const Context& context,
             MeshAudit& audit) {
  for (const Triangle& triangle : triangles) {
    for (const uint32_t vertex : triangle) {
      audit.bounding_box.extend(mesh.positions[vertex]);
    }
  }
  if (triangles.empty()) {
    return;
  }
  // Volumes are taken from the centre: less is lost to rounding.
  const Eigen::Vector3d origin = audit.bounding_box.center();
  std::vector<TriangleSums> chunks(NumChunks(triangles.size(), kAuditGrain));
  ParallelChunks(context,
                 triangles.size(),
                 kAuditGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   chunks[chunk] =
                       MeasureTriangles(mesh, triangles, origin, begin, end);
                 });
  for (const TriangleSums& chunk : chunks) {
    audit.area += chunk.area;
    audit.volume += chunk.volume;
    audit.num_degenerate_triangles += chunk.num_flat;
  }
}

void AuditVertices(const std::vector<Triangle>& triangles,
                   size_t num_vertices,
                   const Context& context,
                   MeshAudit& audit) {
  const VertexCorners corners = FindVertexCorners(num_vertices, triangles);
  std::vector<MeshAudit> chunks(NumChunks(num_vertices, kAuditGrain));
  ParallelChunks(context,
                 num_vertices,
                 kAuditGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   VertexAuditor auditor;
                   for (size_t v = begin; v < end; ++v) {
                     auditor.Audit(
                         triangles, corners.Of(v), uint32_t(v), chunks[chunk]);
                   }
                 });
  for (const MeshAudit& chunk : chunks) {
    audit.num_edges += chunk.num_edges;
    audit.num_boundary_edges += chunk.num_boundary_edges;
    audit.num_nonmanifold_edges += chunk.num_nonmanifold_edges;
    audit.num_misoriented_edges += chunk.num_misoriented_edges;
    audit.num_nonmanifold_vertices += chunk.num_nonmanifold_vertices;
    audit.num_duplicate_triangles += chunk.num_duplicate_triangles;
  }
}

size_t CountUnreferenced(const IndexedMesh& mesh) {
  std::vector<uint8_t> referenced(mesh.positions.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const uint32_t vertex : triangle) {
      if (vertex >= mesh.positions.size()) {
        throw InputError(
            fmt::format("triangle index {} in a mesh of {} "
                        "vertices",
                        vertex,
                        mesh.positions.size()));
      }
      referenced[vertex] = 1;
    }
  }
  return std::count(referenced.begin(), referenced.end(), 0);
}

}  // namespace

MeshAudit AuditMesh(const IndexedMesh& mesh, const Context& context) {
  MeshAudit audit;
  audit.num_vertices = mesh.positions.size();
  audit.num_triangles = mesh.triangles.size();
  audit.num_unreferenced_vertices = CountUnreferenced(mesh);
  for (const Eigen::Vector3d& position : mesh.positions) {
    audit.num_nonfinite_vertices += !position.allFinite();
  }
  std::vector<Triangle> usable;
  usable.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    if (HasRepeatedIndex(triangle)) {
      ++audit.num_degenerate_triangles;
    } else if (audit.num_nonfinite_vertices == 0 ||
               (mesh.positions[triangle[0]].allFinite() &&
                mesh.positions[triangle[1]].allFinite() &&
                mesh.positions[triangle[2]].allFinite())) {
      usable.push_back(triangle);
    }
  }
  Measure(mesh, usable, context, audit);
  AuditVertices(usable, mesh.positions.size(), context, audit);
  const MeshComponents components =
      FindComponents(mesh.positions.size(), usable);
  audit.num_components = components.count;
  const int64_t num_connected =
      int64_t(mesh.positions.size()) - std::count(components.of_vertex.begin(),
                                                  components.of_vertex.end(),
                                                  MeshComponents::kNone);
  audit.euler_characteristic =
      num_connected - int64_t(audit.num_edges) + int64_t(usable.size());
  if (audit.IsClosed() && audit.IsEdgeManifold() && audit.IsVertexManifold() &&
      audit.IsOriented()) {
    // Euler: the characteristic of a closed surface is 2 - 2 genus.
    audit.genus =
        int64_t(audit.num_components) - audit.euler_characteristic / 2;
  }
  return audit;
}

std::string MeshAudit::DescribeFailure() const {
  std::string failures;
  const auto report = [&](size_t count, const char* what) {
    if (count > 0) {
      failures +=
          fmt::format("{}{} {}", failures.empty() ? "" : ", ", count, what);
    }
  };
  if (num_triangles == 0) {
    return "no triangles";
  }
  report(num_nonfinite_vertices, "vertices that are not finite");
  report(num_boundary_edges, "boundary edges");
  report(num_nonmanifold_edges, "non-manifold edges");
  report(num_nonmanifold_vertices, "non-manifold vertices");
  report(num_misoriented_edges, "misoriented edges");
  report(num_degenerate_triangles, "degenerate triangles");
  report(num_duplicate_triangles, "duplicate triangles");
  report(num_unreferenced_vertices, "unreferenced vertices");
  if (!IsOutward()) {
    failures += fmt::format(
        "{}volume {} is not positive", failures.empty() ? "" : ", ", volume);
  }
  return failures;
}

void CheckAudit(const MeshAudit& audit) {
  const std::string failures = audit.DescribeFailure();
  if (!failures.empty()) {
    throw InvariantError(fmt::format("the mesh has {}", failures));
  }
}

}  // namespace octacut
