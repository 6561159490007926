#include "core/extract/extract_surface.h"

#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "tests/core/extract/label_crust.h"

namespace octacut {
namespace {

ExtractedSurface Extract(const LabelledCrust& labelled) {
  const int level = labelled.crust.Level();
  return ExtractSurface(
      labelled.crust, labelled.labels, UnitVoxels(level), Context(1));
}

// The six faces of the voxel in the middle of 3^3 voxels, all others the same.
LabelledCrust LabelSingleVoxel(int labels, bool others) {
  return LabelBlock(
      2, {1, 0, 1}, {3, 3, 3}, others, [&](int axis, int x, int y, int z) {
        Eigen::Vector3i at(x, y, z);
        const int side = at[axis] - 1;
        at[axis] = 1;
        if (at != Eigen::Vector3i::Ones() || side < 0 || side > 1) {
          return others;
        }
        return (labels >> (2 * axis + side) & 1) != 0;
      });
}

TEST(ExtractSurface, AllLabellingsOfAVoxelAreClosedManifolds) {
  for (int labels = 0; labels < 64; ++labels) {
    for (const bool others : {false, true}) {
      SCOPED_TRACE(testing::Message()
                   << "labels " << labels << " others " << others);
      const ExtractedSurface surface =
          Extract(LabelSingleVoxel(labels, others));
      if (labels == (others ? kAllFaces : 0)) {
        EXPECT_TRUE(surface.mesh.triangles.empty());
        EXPECT_TRUE(surface.mesh.positions.empty());
      } else {
        ExpectClosedManifold(AuditMesh(surface.mesh, Context(1)));
      }
    }
  }
}

TEST(ExtractSurface, AllLabellingsAroundACornerAreClosedManifolds) {
  ExtractSurfaceSummary sum;
  for (int border = 0; border < 2; ++border) {
    for (int labels = 0; labels < 4096; ++labels) {
      // Twelve faces inside a block of 2^3.
      const LabelledCrust block =
          LabelBlock(3,
                     {3, 3, 3},
                     {2, 2, 2},
                     border != 0,
                     [&](int axis, int x, int y, int z) {
                       const Eigen::Vector3i at(x, y, z);
                       return (labels >> (4 * axis + at[(axis + 1) % 3] +
                                          2 * at[(axis + 2) % 3]) &
                               1) != 0;
                     });
      const ExtractedSurface surface = Extract(block);
      if (surface.mesh.triangles.empty()) {
        continue;
      }
      ExpectClosedManifold(AuditMesh(surface.mesh, Context(1)));
      EXPECT_EQ(NumIntersections(surface.mesh), 0);
      ASSERT_FALSE(HasFailure()) << "labels " << labels;
      sum.num_four_polygon_edges += surface.summary.num_four_polygon_edges;
      sum.num_split_vertices += surface.summary.num_split_vertices;
      sum.num_fans += surface.summary.num_fans;
    }
  }
  EXPECT_GT(sum.num_four_polygon_edges, 0);
  EXPECT_GT(sum.num_split_vertices, 0);
  EXPECT_GT(sum.num_fans, 0);
}

TEST(ExtractSurface, RandomBlocksAreClosedManifolds) {
  std::mt19937 random(1);
  ExtractSurfaceSummary sum;
  for (int round = 0; round < 2500; ++round) {
    const LabelledCrust block =
        LabelRandomBlock(2 + round % 5, round % 2 != 0, random);
    const ExtractedSurface surface = Extract(block);
    sum.num_four_polygon_edges += surface.summary.num_four_polygon_edges;
    sum.num_split_vertices += surface.summary.num_split_vertices;
    sum.num_fans += surface.summary.num_fans;
    sum.num_edge_vertices += surface.summary.num_edge_vertices;
    if (!surface.mesh.triangles.empty()) {
      ExpectClosedManifold(AuditMesh(surface.mesh, Context(1)));
      EXPECT_EQ(NumIntersections(surface.mesh), 0);
      ASSERT_FALSE(HasFailure()) << "round " << round;
    }
  }
  // Each of the rare cases must have occurred.
  EXPECT_GT(sum.num_four_polygon_edges, 1000);
  EXPECT_GT(sum.num_split_vertices, 1000);
  EXPECT_GT(sum.num_fans, 1000);
  EXPECT_GT(sum.num_edge_vertices, 10);
}

TEST(ExtractSurface, FourPolygonsInAnEdgeJoinAcrossTheOutside) {
  // Two inside faces opposite each other across a grid edge along z.
  const LabelledCrust block =
      LabelBlock(3, {2, 2, 2}, {2, 2, 3}, false, [](int axis, int, int, int z) {
        return axis == 0 && z == 1;
      });
  const ExtractedSurface surface = Extract(block);
  EXPECT_EQ(surface.summary.num_four_polygon_edges, 1);
  const MeshAudit audit = AuditMesh(surface.mesh, Context(1));
  ExpectClosedManifold(audit);
  // The inside faces hang together there.
  EXPECT_EQ(audit.num_components, 1);
  EXPECT_EQ(audit.genus, 0);

  // The complement: two outside faces in the inside, kept apart.
  LabelledCrust complement = block;
  for (FaceLabels& labels : complement.labels) {
    labels ^= kAllFaces;
  }
  const ExtractedSurface cavities = Extract(complement);
  EXPECT_EQ(cavities.summary.num_four_polygon_edges, 1);
  const MeshAudit cavity_audit = AuditMesh(cavities.mesh, Context(1));
  ExpectClosedManifold(cavity_audit);
  EXPECT_EQ(cavity_audit.num_components, 2);
}

TEST(ExtractSurface, TwoQuadsBackToBackDrawDifferentDiagonals) {
  const LabelledCrust block = LabelBlock(
      2, {1, 1, 1}, {2, 1, 1}, false, [](int, int, int, int) { return true; });
  const ExtractedSurface surface = Extract(block);
  EXPECT_EQ(surface.summary.num_polygons, 2);
  EXPECT_EQ(surface.summary.num_fans, 1);
  EXPECT_EQ(surface.mesh.positions.size(), 5);  // and the centre of a voxel
  EXPECT_EQ(surface.mesh.triangles.size(), 6);
  ExpectClosedManifold(AuditMesh(surface.mesh, Context(1)));
}

TEST(ExtractSurface, FacesOutwardInWorldCoordinates) {
  // Four voxels in a ring around a grid edge along z, all faces between them
  // inside.
  const LabelledCrust block = LabelBlock(
      3, {2, 4, 5}, {2, 2, 1}, false, [](int, int, int, int) { return true; });
  const BoundingCube cube{Eigen::Vector3d(10, -20, 30), 4};
  const ExtractedSurface surface =
      ExtractSurface(block.crust, block.labels, cube, Context(1));
  EXPECT_DOUBLE_EQ(surface.voxel_size, 0.5);
  // Corners of voxels, and centres of those drawn as fans.
  for (const Eigen::Vector3d& position : surface.mesh.positions) {
    const Eigen::Vector3d half_voxels = (position - cube.min_corner) * 4;
    EXPECT_EQ(half_voxels, half_voxels.array().round().matrix());
  }
  const MeshAudit audit = AuditMesh(surface.mesh, Context(1));
  ExpectClosedManifold(audit);
  EXPECT_EQ(audit.bounding_box.min(), Eigen::Vector3d(11, -18, 32.5));
  EXPECT_EQ(audit.bounding_box.max(), Eigen::Vector3d(12, -17, 33));
  EXPECT_GT(audit.volume, 0);
}

TEST(ExtractSurface, NeedsNoVoxelThatIsNotCut) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    const LabelledCrust block = LabelRandomBlock(5, round % 2 != 0, random);
    std::vector<MortonCode> codes;
    LabelledCrust only_cut;
    block.crust.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      if (IsCut(block.labels[index])) {
        codes.push_back(code);
        only_cut.labels.push_back(block.labels[index]);
      }
    });
    only_cut.crust = VoxelGrid::FromCodes(4, codes);
    const ExtractedSurface expected = Extract(block);
    const ExtractedSurface actual = Extract(only_cut);
    EXPECT_EQ(actual.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(actual.mesh.triangles, expected.mesh.triangles);
  }
}

TEST(ExtractSurface, RefusesLabelsThatBoundNoVolume) {
  LabelledCrust block =
      LabelBlock(2, {0, 0, 0}, {2, 2, 2}, false, [](int axis, int, int, int) {
        return axis == 0;
      });
  block.labels.pop_back();
  EXPECT_THROW(Extract(block), InputError);  // one label is missing
  block.labels.push_back(0);
  EXPECT_THROW(Extract(block), InputError);  // a neighbour says otherwise
  block.labels.back() = 0x40;
  EXPECT_THROW(Extract(block), InputError);  // no such face

  LabelledCrust open;
  open.crust = VoxelGrid::FromCodes(2, {EncodeMorton(1, 1, 1)});
  open.labels = {1};
  EXPECT_THROW(Extract(open), InputError);  // ends at the border of the crust
}

TEST(ExtractSurface, EmptyCrustGivesAnEmptyMesh) {
  const ExtractedSurface surface = ExtractSurface(
      VoxelGrid::FromCodes(3, {}), {}, UnitVoxels(3), Context(1));
  EXPECT_TRUE(surface.mesh.positions.empty());
  EXPECT_TRUE(surface.mesh.triangles.empty());
}

TEST(ExtractSurface, SameBytesForAnyNumberOfThreads) {
  const LabelledCrust torus = LabelShape(7, TorusDistance);
  const ExtractedSurface expected =
      ExtractSurface(torus.crust, torus.labels, UnitCube(), Context(1));
  EXPECT_EQ(AuditMesh(expected.mesh, Context(1)).genus, 1);
  for (const int num_threads : {2, 4}) {
    const ExtractedSurface actual = ExtractSurface(
        torus.crust, torus.labels, UnitCube(), Context(num_threads));
    EXPECT_EQ(actual.mesh.positions, expected.mesh.positions);
    EXPECT_EQ(actual.mesh.triangles, expected.mesh.triangles);
    EXPECT_EQ(actual.octants, expected.octants);
  }
}

}  // namespace
}  // namespace octacut
