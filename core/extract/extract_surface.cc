#include "core/extract/extract_surface.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/extract/loop_choices.h"
#include "core/extract/shared_edges.h"

namespace octacut {
namespace {

constexpr OctantMask kAllOctants = 0xff;

// Everything that a polygon's triangles are written from.
struct Drawing {
  CutVoxels cut;
  UmbrellaVertices umbrellas;
  LoopChoices choices;
  SharedEdges shared;
  uint32_t first_edge_vertex = 0;  // vertex of edge vertex 0
};

// The vertices of a loop in order, edge vertices among them.
struct LoopVertices {
  int size = 0;
  uint32_t ids[16];
};

LoopVertices VerticesOf(const Drawing& drawing,
                        CutVoxels::Index number,
                        FaceLabels labels,
                        const SplitLoop& loop) {
  const std::vector<EdgeVertex>& edges = drawing.shared.edge_vertices;
  auto edge = edges.end();
  if (!edges.empty() && drawing.umbrellas.near_four_polygon_edge[number]) {
    edge =
        std::lower_bound(edges.begin(),
                         edges.end(),
                         number,
                         [](const EdgeVertex& vertex, CutVoxels::Index value) {
                           return vertex.number < value;
                         });
  }
  LoopVertices result;
  for (int j = 0; j < loop.size; ++j) {
    const int corner = loop.corners[j];
    result.ids[result.size++] =
        drawing.umbrellas
            .vertices[drawing.umbrellas.Slot(number, labels, corner)];
    for (auto e = edge; e != edges.end() && e->number == number; ++e) {
      if (e->from == corner) {
        result.ids[result.size++] = drawing.first_edge_vertex + e->id;
      }
    }
  }
  return result;
}

struct Counts {
  size_t triangles = 0;
  size_t fans = 0;
  size_t polygons = 0;
};

void CountOfVoxel(const Drawing& drawing,
                  CutVoxels::Index number,
                  FaceLabels labels,
                  Counts& counts) {
  const SplitLoops& loops = kSplitLoopTable[labels];
  counts.polygons += loops.num_loops;
  for (int i = 0; i < loops.num_loops; ++i) {
    const SplitLoop& loop = loops.loops[i];
    if (drawing.shared.fans[number] >> i & 1) {
      ++counts.fans;
      counts.triangles += VerticesOf(drawing, number, labels, loop).size;
    } else {
      counts.triangles += loop.size - 2;
    }
  }
}

// Writes the triangles of a voxel; `next` tells where, and which vertex is
// the next fan's centre.
void WriteVoxel(const Drawing& drawing,
                CutVoxels::Index number,
                FaceLabels labels,
                const Eigen::Vector3d& center,
                Counts& next,
                ExtractedSurface& surface) {
  const SplitLoops& loops = kSplitLoopTable[labels];
  auto& triangles = surface.mesh.triangles;
  for (int i = 0; i < loops.num_loops; ++i) {
    const SplitLoop& loop = loops.loops[i];
    const LoopVertices vertices = VerticesOf(drawing, number, labels, loop);
    if (drawing.shared.fans[number] >> i & 1) {
      surface.mesh.positions[next.fans] = center;
      surface.octants[next.fans] = kAllOctants;
      for (int j = 0; j < vertices.size; ++j) {
        triangles[next.triangles++] = {vertices.ids[j],
                                       vertices.ids[(j + 1) % vertices.size],
                                       uint32_t(next.fans)};
      }
      ++next.fans;
      continue;
    }
    const int choice = drawing.choices.OfLoop(number, loops, i);
    for (const LoopTriangle& triangle : LoopTriangulation(loop.size, choice)) {
      triangles[next.triangles++] = {vertices.ids[triangle[0]],
                                     vertices.ids[triangle[1]],
                                     vertices.ids[triangle[2]]};
    }
  }
}

// Counts per chunk, turned into where each chunk begins; returns the sums.
Counts CountTriangles(const Drawing& drawing,
                      const Context& context,
                      std::vector<Counts>& chunks) {
  const CutVoxels& cut = drawing.cut;
  ParallelChunks(context,
                 cut.Crust().Bricks().size(),
                 kBricksPerChunk,
                 [&](size_t chunk, size_t begin, size_t end) {
                   for (size_t brick = begin; brick < end; ++brick) {
                     cut.ForEachInBrick(
                         brick,
                         [&](CutVoxels::Index number, int, FaceLabels labels) {
                           CountOfVoxel(drawing, number, labels, chunks[chunk]);
                         });
                   }
                 });
  Counts total;
  for (Counts& chunk : chunks) {
    const Counts begin = total;
    total.triangles += chunk.triangles;
    total.fans += chunk.fans;
    total.polygons += chunk.polygons;
    chunk = begin;
  }
  return total;
}

// Vertices: those of the umbrellas, then edge vertices, then centres of fans.
void WriteMesh(Drawing& drawing,
               const BoundingCube& cube,
               const Context& context,
               ExtractedSurface& surface) {
  const std::vector<VoxelGrid::Brick>& bricks = drawing.cut.Crust().Bricks();
  std::vector<Counts> chunks(NumChunks(bricks.size(), kBricksPerChunk));
  const Counts total = CountTriangles(drawing, context, chunks);
  surface.summary.num_polygons = total.polygons;

  auto& positions = surface.mesh.positions;
  positions = std::move(drawing.umbrellas.positions);
  surface.octants = std::move(drawing.umbrellas.octants);
  drawing.first_edge_vertex = uint32_t(positions.size());
  positions.insert(positions.end(),
                   drawing.shared.edge_positions.begin(),
                   drawing.shared.edge_positions.end());
  surface.octants.insert(surface.octants.end(),
                         drawing.shared.edge_octants.begin(),
                         drawing.shared.edge_octants.end());
  const size_t first_center = positions.size();
  positions.resize(first_center + total.fans);
  surface.octants.resize(positions.size());
  surface.mesh.triangles.resize(total.triangles);
  ParallelChunks(
      context,
      bricks.size(),
      kBricksPerChunk,
      [&](size_t chunk, size_t begin, size_t end) {
        Counts next = chunks[chunk];
        next.fans += first_center;
        for (size_t brick = begin; brick < end; ++brick) {
          drawing.cut.ForEachInBrick(
              brick, [&](CutVoxels::Index number, int bit, FaceLabels labels) {
                const Eigen::Vector3d voxel =
                    DecodeMorton(VoxelGrid::CodeOf(bricks[brick], bit))
                        .cast<double>();
                const Eigen::Vector3d center =
                    cube.min_corner +
                    surface.voxel_size *
                        (voxel + Eigen::Vector3d::Constant(0.5));
                WriteVoxel(drawing, number, labels, center, next, surface);
              });
        }
      });
}

}  // namespace

ExtractedSurface ExtractSurface(const VoxelGrid& crust,
                                std::span<const FaceLabels> labels,
                                const BoundingCube& cube,
                                const Context& context) {
  if (labels.size() != crust.Size()) {
    throw InputError(fmt::format("{} face labels for a crust of {} voxels",
                                 labels.size(),
                                 crust.Size()));
  }
  ExtractedSurface surface;
  surface.voxel_size = cube.VoxelSize(crust.Level());
  Drawing drawing{CutVoxels(crust, labels), {}, {}, {}};
  drawing.umbrellas = FindUmbrellaVertices(drawing.cut, cube, context);
  drawing.choices = ChooseLoops(drawing.cut, drawing.umbrellas, context);
  drawing.shared = FindSharedEdges(
      drawing.cut, drawing.umbrellas, drawing.choices, cube, context);
  surface.summary.num_four_polygon_edges =
      drawing.shared.num_four_polygon_edges;
  surface.summary.num_split_vertices = drawing.umbrellas.num_extra;
  surface.summary.num_fans = drawing.shared.num_fans;
  surface.summary.num_edge_vertices = drawing.shared.edge_positions.size();
  WriteMesh(drawing, cube, context, surface);
  return surface;
}

}  // namespace octacut
