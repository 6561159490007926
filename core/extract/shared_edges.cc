#include "core/extract/shared_edges.h"

#include <algorithm>
#include <tuple>

#include "core/base/parallel.h"
#include "core/extract/cube_topology.h"
#include "core/extract/octant_mean.h"

namespace octacut {
namespace {

// How far an edge vertex lies from its edge, of the way to OctantMean. On the
// edge itself its triangles would touch those of the other pair.
constexpr double kEdgeVertexOffset = 1.0 / 32;

Eigen::Vector3i CornerOffset(int k) { return {k & 1, k >> 1 & 1, k >> 2 & 1}; }

struct CutVoxel {
  CutVoxels::Index number;
  Eigen::Vector3i coordinates;
  FaceLabels labels;
};

class SharedEdgeFinder {
 public:
  SharedEdgeFinder(const CutVoxels& cut,
                   const UmbrellaVertices& umbrellas,
                   const LoopChoices& choices,
                   const BoundingCube& cube)
      : cut_(cut),
        umbrellas_(umbrellas),
        choices_(choices),
        cube_(cube),
        voxel_size_(cube.VoxelSize(cut.Crust().Level())) {}

  // Returns the fans of a voxel and adds what it finds to `result`.
  uint8_t Find(const CutVoxel& voxel, SharedEdges& result) const {
    const SplitLoops& loops = kSplitLoopTable[voxel.labels];
    uint8_t fans = 0;
    for (int i = 0; i < loops.num_loops; ++i) {
      const SplitLoop& loop = loops.loops[i];
      const int choice = choices_.OfLoop(voxel.number, loops, i);
      bool is_fan = CrossesItself(loop, choice);
      ForEachChord(loop, choice, [&](int a, int b) {
        is_fan |= LosesChord(voxel, a, b);
      });
      result.num_fans += is_fan ? 1 : 0;
      if (umbrellas_.near_four_polygon_edge[voxel.number]) {
        for (int j = 0; j < loop.size; ++j) {
          const int next = loop.corners[(j + 1) % loop.size];
          is_fan |= NeedsEdgeVertex(voxel, loop.corners[j], next, result);
        }
      }
      fans |= uint8_t(unsigned(is_fan) << i);
    }
    return fans;
  }

 private:
  // Whether the voxel across `axes` has the same vertices at corners a and b.
  bool SharesVertices(const CutVoxel& voxel,
                      int a,
                      int b,
                      unsigned axes) const {
    const OctantMask at_a = umbrellas_.Umbrella(voxel.number, voxel.labels, a);
    const OctantMask at_b = umbrellas_.Umbrella(voxel.number, voxel.labels, b);
    return (at_a >> (7 ^ a ^ axes) & 1) && (at_b >> (7 ^ b ^ axes) & 1);
  }

  bool LosesChord(const CutVoxel& voxel, int a, int b) const {
    const unsigned shared = SharedAxes(a, b);
    if (IsFaceDiagonal(a, b)) {
      return LosesFace(voxel, a, shared);
    }
    // A cube edge; voxels have no body diagonal in common.
    for (unsigned axes = shared; axes != 0; axes = (axes - 1) & shared) {
      if (!SharesVertices(voxel, a, b, axes)) {
        continue;
      }
      const auto other = cut_.FindAcross(voxel.coordinates, a, axes);
      const int other_a = a ^ int(axes);
      const int other_b = b ^ int(axes);
      if (IsSplitEdge(other.labels, other_a, other_b)) {
        return true;
      }
      const bool drawn_by_other =
          choices_.chords[other.number] >> ChordNumber(other_a, other_b) & 1;
      if (drawn_by_other && other.number < voxel.number) {
        return true;
      }
    }
    return false;
  }

  // Whether the voxel across the face of corner `k` draws in that face, too:
  // the triangles of both would lie on each other.
  bool LosesFace(const CutVoxel& voxel, int k, unsigned axes) const {
    const auto other = cut_.FindAcross(voxel.coordinates, k, axes);
    if (other.number == CutVoxels::kNone || other.number > voxel.number) {
      return false;
    }
    const int face = FaceAtCorner(k ^ int(axes), std::countr_zero(axes));
    return choices_.chords[other.number] >> (2 * face) & 3;
  }

  // Whether the pair of polygons of this voxel's side of the split edge a - b
  // is to be joined through an edge vertex; the first voxel of the pair adds
  // it.
  bool NeedsEdgeVertex(const CutVoxel& voxel,
                       int a,
                       int b,
                       SharedEdges& result) const {
    const unsigned shared = SharedAxes(a, b);
    const int first_axis = std::countr_zero(shared);
    const bool first_is_inside =
        voxel.labels >> FaceAtCorner(a, first_axis) & 1;
    const unsigned inside_axis =
        first_is_inside ? 1u << first_axis : shared ^ 1u << first_axis;
    const unsigned outside_axis = shared ^ inside_axis;
    CutVoxels::Index numbers[4] = {voxel.number};
    for (unsigned axes = shared; axes != 0; axes = (axes - 1) & shared) {
      const auto other = cut_.FindAcross(voxel.coordinates, a, axes);
      if (other.number == CutVoxels::kNone ||
          !IsSplitEdge(other.labels, a ^ int(axes), b ^ int(axes))) {
        return false;
      }
      numbers[axes == outside_axis ? 1 : (axes == inside_axis ? 2 : 3)] =
          other.number;
    }
    // The polygons are joined across the outside faces: 0 and 1, 2 and 3.
    const CutVoxels::Index pair = std::min(numbers[0], numbers[1]);
    const CutVoxels::Index other_pair = std::min(numbers[2], numbers[3]);
    result.num_four_polygon_edges += voxel.number == std::min(pair, other_pair);
    if (pair < other_pair || !SharesVertices(voxel, a, b, shared)) {
      return false;
    }
    if (voxel.number == pair) {
      AddEdgeVertex(voxel, numbers[1], a, b, outside_axis, result);
    }
    return true;
  }

  void AddEdgeVertex(const CutVoxel& voxel,
                     CutVoxels::Index partner,
                     int a,
                     int b,
                     unsigned outside_axis,
                     SharedEdges& result) const {
    const uint32_t id = uint32_t(result.edge_positions.size());
    result.edge_vertices.push_back({voxel.number, uint8_t(a), id});
    // The partner's loop runs along the edge the other way.
    result.edge_vertices.push_back({partner, uint8_t(b ^ outside_axis), id});
    const OctantMask octants =
        OctantMask(1u << (7 ^ a) | 1u << (7 ^ b) |
                   1u << (7 ^ a ^ outside_axis) | 1u << (7 ^ b ^ outside_axis));
    const Eigen::Vector3d middle =
        voxel.coordinates.cast<double>() +
        (CornerOffset(a) + CornerOffset(b)).cast<double>() / 2;
    result.edge_positions.push_back(
        cube_.min_corner +
        voxel_size_ * (middle + kEdgeVertexOffset * OctantMean(octants)));
    result.edge_octants.push_back(octants);
  }

  const CutVoxels& cut_;
  const UmbrellaVertices& umbrellas_;
  const LoopChoices& choices_;
  const BoundingCube& cube_;
  double voxel_size_;
};

void Append(const SharedEdges& chunk, SharedEdges& all) {
  const uint32_t first_id = uint32_t(all.edge_positions.size());
  for (EdgeVertex vertex : chunk.edge_vertices) {
    vertex.id += first_id;
    all.edge_vertices.push_back(vertex);
  }
  all.edge_positions.insert(all.edge_positions.end(),
                            chunk.edge_positions.begin(),
                            chunk.edge_positions.end());
  all.edge_octants.insert(all.edge_octants.end(),
                          chunk.edge_octants.begin(),
                          chunk.edge_octants.end());
  all.num_four_polygon_edges += chunk.num_four_polygon_edges;
  all.num_fans += chunk.num_fans;
}

}  // namespace

SharedEdges FindSharedEdges(const CutVoxels& cut,
                            const UmbrellaVertices& umbrellas,
                            const LoopChoices& choices,
                            const BoundingCube& cube,
                            const Context& context) {
  const SharedEdgeFinder finder(cut, umbrellas, choices, cube);
  const std::vector<VoxelGrid::Brick>& bricks = cut.Crust().Bricks();
  SharedEdges result;
  result.fans.resize(cut.Size());
  std::vector<SharedEdges> chunks(NumChunks(bricks.size(), kBricksPerChunk));
  ParallelChunks(
      context,
      bricks.size(),
      kBricksPerChunk,
      [&](size_t chunk, size_t begin, size_t end) {
        for (size_t brick = begin; brick < end; ++brick) {
          cut.ForEachInBrick(
              brick, [&](CutVoxels::Index number, int bit, FaceLabels labels) {
                const CutVoxel voxel{
                    number,
                    DecodeMorton(VoxelGrid::CodeOf(bricks[brick], bit)),
                    labels};
                result.fans[number] = finder.Find(voxel, chunks[chunk]);
              });
        }
      });
  for (const SharedEdges& chunk : chunks) {
    Append(chunk, result);
  }
  std::sort(result.edge_vertices.begin(),
            result.edge_vertices.end(),
            [](const EdgeVertex& a, const EdgeVertex& b) {
              return std::tie(a.number, a.from) < std::tie(b.number, b.from);
            });
  return result;
}

}  // namespace octacut
