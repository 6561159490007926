#include "tests/core/extract/label_crust.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/self_intersections.h"

namespace octacut {

LabelledCrust LabelBlock(int level,
                         const Eigen::Vector3i& low,
                         const Eigen::Vector3i& size,
                         bool border,
                         const FaceIsInside& inside) {
  std::vector<MortonCode> codes;
  for (int z = 0; z < size.z(); ++z) {
    for (int y = 0; y < size.y(); ++y) {
      for (int x = 0; x < size.x(); ++x) {
        codes.push_back(EncodeMorton(low + Eigen::Vector3i(x, y, z)));
      }
    }
  }
  LabelledCrust result;
  result.crust = VoxelGrid::FromCodes(level, codes);
  result.labels.resize(result.crust.Size());
  result.crust.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const Eigen::Vector3i voxel = DecodeMorton(code) - low;
    for (int face = 0; face < kNumFaces; ++face) {
      const int axis = face / 2;
      Eigen::Vector3i at = voxel;
      at[axis] += face & 1;
      const bool on_border = at[axis] == 0 || at[axis] == size[axis];
      const bool label =
          on_border ? border : inside(axis, at.x(), at.y(), at.z());
      result.labels[index] |= FaceLabels(unsigned(label) << face);
    }
  });
  return result;
}

LabelledCrust LabelRandomBlock(int side, bool border, std::mt19937& random) {
  const int level = 4;
  std::uniform_int_distribution<int> shift(0, (1 << level) - side);
  const Eigen::Vector3i low(shift(random), shift(random), shift(random));
  std::bernoulli_distribution coin(
      std::uniform_real_distribution<>(0, 1)(random));
  std::vector<uint8_t> faces(3 * side * side * side);
  for (uint8_t& face : faces) {
    face = coin(random);
  }
  return LabelBlock(level,
                    low,
                    Eigen::Vector3i::Constant(side),
                    border,
                    [&](int axis, int x, int y, int z) {
                      return faces[axis + 3 * (x + side * (y + side * z))] != 0;
                    });
}

LabelledCrust LabelShape(
    int level, const std::function<double(const Eigen::Vector3d&)>& distance) {
  std::vector<MortonCode> codes = {0};
  for (int l = 1; l <= level; ++l) {
    const double size = 1.0 / (1 << l);
    std::vector<MortonCode> children;
    for (const MortonCode code : codes) {
      for (int i = 0; i < 8; ++i) {
        const MortonCode child = FirstChildCode(code) + i;
        const Eigen::Vector3d center =
            size * (DecodeMorton(child).cast<double>().array() + 0.5).matrix();
        if (std::abs(distance(center)) < 2 * size) {
          children.push_back(child);
        }
      }
    }
    codes = std::move(children);
  }
  const double size = 1.0 / (1 << level);
  LabelledCrust result;
  result.crust = VoxelGrid::FromCodes(level, std::move(codes));
  result.labels.resize(result.crust.Size());
  result.crust.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    for (int face = 0; face < kNumFaces; ++face) {
      Eigen::Vector3d at =
          (DecodeMorton(code).cast<double>().array() + 0.5).matrix();
      at[face / 2] += (face & 1) ? 0.5 : -0.5;
      const bool inside = distance(size * at) < 0;
      result.labels[index] |= FaceLabels(unsigned(inside) << face);
    }
  });
  return result;
}

double SphereDistance(const Eigen::Vector3d& point) {
  return (point - Eigen::Vector3d(0.503, 0.499, 0.501)).norm() - 0.4;
}

double TorusDistance(const Eigen::Vector3d& point) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  const Eigen::Vector3d from_center =
      point - Eigen::Vector3d(0.503, 0.499, 0.501);
  const double height = from_center.dot(axis);
  const double radius = (from_center - height * axis).norm();
  return std::hypot(radius - 0.27, height) - 0.12;
}

size_t NumIntersections(const IndexedMesh& mesh) {
  return FindSelfIntersections(mesh, Context(1)).num_pairs;
}

IndexedMesh Place(const LabelledCrust& labelled, const BoundingCube& cube) {
  return PositionVertices(
      ExtractSurface(labelled.crust, labelled.labels, cube, Context(1)),
      Context(1));
}

BoundingCube UnitVoxels(int level) {
  return {Eigen::Vector3d::Zero(), double(1 << level)};
}

BoundingCube UnitCube() { return {Eigen::Vector3d::Zero(), 1}; }

void ExpectClosedManifold(const MeshAudit& audit) {
  EXPECT_TRUE(audit.IsClosed());
  EXPECT_EQ(audit.num_boundary_edges, 0);
  EXPECT_EQ(audit.num_nonmanifold_edges, 0);
  EXPECT_EQ(audit.num_nonmanifold_vertices, 0);
  EXPECT_EQ(audit.num_misoriented_edges, 0);
  EXPECT_EQ(audit.num_degenerate_triangles, 0);
  EXPECT_EQ(audit.num_duplicate_triangles, 0);
  EXPECT_EQ(audit.num_unreferenced_vertices, 0);
  EXPECT_GE(audit.genus, 0);
}

}  // namespace octacut
