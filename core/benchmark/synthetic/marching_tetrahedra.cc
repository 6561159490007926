#include "core/benchmark/synthetic/marching_tetrahedra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/benchmark/synthetic/key_index.h"

namespace octacut {
namespace {

constexpr size_t kTetrahedraGrain = 1024;

// Lattice nodes have doubled coordinates: even for cell corners, odd for cell
// centres. Cells are named by their lowest corner's plain coordinates.
uint64_t PackKey(const Eigen::Vector3i& v) {
  return static_cast<uint64_t>(v.x()) | static_cast<uint64_t>(v.y()) << 21 |
         static_cast<uint64_t>(v.z()) << 42;
}
Eigen::Vector3i UnpackKey(uint64_t key) {
  constexpr uint64_t kMask = (1u << 21) - 1;
  return {static_cast<int>(key & kMask),
          static_cast<int>(key >> 21 & kMask),
          static_cast<int>(key >> 42 & kMask)};
}

struct Lattice {
  Eigen::Vector3d origin;
  double cell;
  int level;  // 2^level cells along each edge

  Eigen::Vector3d NodePosition(uint64_t key) const {
    return origin + cell / 2 * UnpackKey(key).cast<double>();
  }
};

Lattice MakeLattice(const ImplicitShape& shape, int resolution) {
  Lattice lattice;
  lattice.cell = shape.box.sizes().maxCoeff() / resolution;
  lattice.level = 1;
  while ((1 << lattice.level) < resolution + 4) {
    ++lattice.level;
  }
  const double edge = lattice.cell * (1 << lattice.level);
  // Off the shape's planes of symmetry, where values would be exactly zero.
  const Eigen::Vector3d shift(0.1234567, 0.2345678, 0.3456789);
  lattice.origin = shape.box.center() - Eigen::Vector3d::Constant(edge / 2) +
                   lattice.cell * shift;
  return lattice;
}

// Cells that the surface may cross, in an order of their own: from the root
// down, whatever is further from the surface than half its diagonal falls
// away.
std::vector<uint64_t> FindSurfaceCells(const ImplicitShape& shape,
                                       const Lattice& lattice,
                                       const Context& context) {
  std::vector<uint64_t> cells{0};
  for (int level = 1; level <= lattice.level; ++level) {
    const double edge = lattice.cell * (1 << (lattice.level - level));
    const double reach = shape.lipschitz * edge * std::sqrt(3.0) / 2;
    std::vector<std::vector<uint64_t>> kept(
        NumChunks(cells.size(), kTetrahedraGrain));
    ParallelChunks(
        context,
        cells.size(),
        kTetrahedraGrain,
        [&](size_t chunk, size_t begin, size_t end) {
          for (size_t i = begin; i < end; ++i) {
            const Eigen::Vector3i parent = UnpackKey(cells[i]);
            for (int child = 0; child < 8; ++child) {
              const Eigen::Vector3i cell =
                  2 * parent +
                  Eigen::Vector3i(child & 1, child >> 1 & 1, child >> 2);
              const Eigen::Vector3d center =
                  lattice.origin +
                  edge * (cell.cast<double>() + Eigen::Vector3d::Constant(0.5));
              if (std::abs(shape(center)) <= reach) {
                kept[chunk].push_back(PackKey(cell));
              }
            }
          }
        });
    cells.clear();
    for (const auto& part : kept) {
      cells.insert(cells.end(), part.begin(), part.end());
    }
  }
  return cells;
}

// The lattice's tetrahedra around the given cells and the shape's values at
// their nodes.
struct Sampling {
  KeyIndex nodes{0};
  std::vector<double> values;
  std::vector<std::array<uint32_t, 4>> tetrahedra;  // those that are crossed
};

// Calls body(node keys) for the four tetrahedra between the centres of a cell
// and its neighbour in direction +axis, each with one edge of their face.
template <typename Body>
void ForTetrahedraOfFace(const Eigen::Vector3i& cell, int axis, Body&& body) {
  const Eigen::Vector3i center = 2 * cell + Eigen::Vector3i::Ones();
  Eigen::Vector3i other = center;
  other[axis] += 2;
  Eigen::Vector3i around = center;
  around[axis] += 1;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  constexpr int kSigns[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::array<uint64_t, 4> corners;
  for (int k = 0; k < 4; ++k) {
    Eigen::Vector3i corner = around;
    corner[u] += kSigns[k][0];
    corner[v] += kSigns[k][1];
    corners[k] = PackKey(corner);
  }
  for (int k = 0; k < 4; ++k) {
    body(std::array<uint64_t, 4>{
        PackKey(center), PackKey(other), corners[k], corners[(k + 1) % 4]});
  }
}

Sampling SampleLattice(const ImplicitShape& shape,
                       const Lattice& lattice,
                       const std::vector<uint64_t>& cells,
                       const Context& context) {
  KeyIndex members(cells.size());
  for (const uint64_t cell : cells) {
    members.Insert(cell);
  }
  Sampling sampling;
  sampling.nodes = KeyIndex(3 * cells.size());
  const auto for_tetrahedra = [&](auto&& body) {
    for (const uint64_t key : cells) {
      const Eigen::Vector3i cell = UnpackKey(key);
      for (int axis = 0; axis < 3; ++axis) {
        ForTetrahedraOfFace(cell, axis, body);
        Eigen::Vector3i below = cell;
        below[axis] -= 1;
        if (members.Find(PackKey(below)) == KeyIndex::kNone) {
          ForTetrahedraOfFace(below, axis, body);
        }
      }
    }
  };
  for_tetrahedra([&](const std::array<uint64_t, 4>& keys) {
    for (const uint64_t key : keys) {
      sampling.nodes.Insert(key);
    }
  });
  const std::vector<uint64_t>& keys = sampling.nodes.Keys();
  sampling.values.resize(keys.size());
  ParallelEach(context, keys.size(), kTetrahedraGrain, [&](size_t i) {
    sampling.values[i] = shape(lattice.NodePosition(keys[i]));
  });
  for_tetrahedra([&](const std::array<uint64_t, 4>& tetrahedron) {
    std::array<uint32_t, 4> nodes;
    int num_inside = 0;
    for (int k = 0; k < 4; ++k) {
      nodes[k] = sampling.nodes.Find(tetrahedron[k]);
      num_inside += sampling.values[nodes[k]] < 0;
    }
    if (num_inside > 0 && num_inside < 4) {
      sampling.tetrahedra.push_back(nodes);
    }
  });
  return sampling;
}

class MarchingTetrahedra {
 public:
  MarchingTetrahedra(const Lattice& lattice, const Sampling& sampling)
      : lattice_(lattice),
        sampling_(sampling),
        vertices_(sampling.tetrahedra.size() / 2) {}

  IndexedMesh Run() {
    for (const auto& tetrahedron : sampling_.tetrahedra) {
      AddTetrahedron(tetrahedron);
    }
    return std::move(mesh_);
  }

 private:
  void AddTetrahedron(std::array<uint32_t, 4> nodes) {
    // Inside nodes first.
    std::stable_partition(nodes.begin(), nodes.end(), [&](uint32_t node) {
      return sampling_.values[node] < 0;
    });
    const auto num_inside =
        std::count_if(nodes.begin(), nodes.end(), [&](uint32_t node) {
          return sampling_.values[node] < 0;
        });
    using Crossing = std::pair<int, int>;
    if (num_inside == 2) {
      const std::array<Crossing, 4> quad{{{0, 2}, {1, 2}, {1, 3}, {0, 3}}};
      AddTriangle(nodes, quad[0], quad[1], quad[2]);
      AddTriangle(nodes, quad[0], quad[2], quad[3]);
    } else if (num_inside == 1) {
      AddTriangle(nodes, {0, 1}, {0, 2}, {0, 3});
    } else {
      AddTriangle(nodes, {0, 3}, {1, 3}, {2, 3});
    }
  }

  // A triangle with its corners on three edges, given by their ends (inside,
  // outside) within the tetrahedron.
  void AddTriangle(const std::array<uint32_t, 4>& nodes,
                   std::pair<int, int> a,
                   std::pair<int, int> b,
                   std::pair<int, int> c) {
    // The edges' middles tell the orientation: exact in integers.
    Eigen::Vector3i middles[3];
    Eigen::Vector3i outward = Eigen::Vector3i::Zero();
    std::array<uint32_t, 3> triangle;
    int k = 0;
    for (const auto& [inside, outside] : {a, b, c}) {
      const Eigen::Vector3i from = Node(nodes[inside]);
      const Eigen::Vector3i to = Node(nodes[outside]);
      middles[k] = from + to;
      outward += to - from;
      triangle[k++] = Vertex(nodes[inside], nodes[outside]);
    }
    const Eigen::Vector3i normal =
        (middles[1] - middles[0]).cross(middles[2] - middles[0]);
    if (normal.dot(outward) < 0) {
      std::swap(triangle[1], triangle[2]);
    }
    mesh_.triangles.push_back(triangle);
  }

  Eigen::Vector3i Node(uint32_t node) const {
    return UnpackKey(sampling_.nodes.Keys()[node]);
  }

  uint32_t Vertex(uint32_t inside, uint32_t outside) {
    const uint64_t key = static_cast<uint64_t>(std::min(inside, outside))
                             << 32 |
                         std::max(inside, outside);
    const uint32_t vertex = vertices_.Insert(key);
    if (vertex == mesh_.positions.size()) {
      const double from = sampling_.values[inside];
      const double to = sampling_.values[outside];
      // Kept from the nodes, where many edges' vertices would meet.
      const double t = std::clamp(from / (from - to), 0.15, 0.85);
      const auto& keys = sampling_.nodes.Keys();
      mesh_.positions.push_back((1 - t) * lattice_.NodePosition(keys[inside]) +
                                t * lattice_.NodePosition(keys[outside]));
    }
    return vertex;
  }

  const Lattice& lattice_;
  const Sampling& sampling_;
  KeyIndex vertices_;
  IndexedMesh mesh_;
};

}  // namespace

MarchedSurface MarchTetrahedra(const ImplicitShape& shape,
                               int resolution,
                               const Context& context) {
  const Lattice lattice = MakeLattice(shape, resolution);
  const std::vector<uint64_t> cells = FindSurfaceCells(shape, lattice, context);
  const Sampling sampling = SampleLattice(shape, lattice, cells, context);
  return {MarchingTetrahedra(lattice, sampling).Run(), lattice.cell};
}

}  // namespace octacut
