#include <gmock/gmock.h>

#include <clocale>
#include <locale>
#include <sstream>

#include "colmap_io/mesh/mesh_writers.h"
#include "core/base/error.h"
#include "tests/colmap_io/mesh/test_meshes.h"

namespace octacut {
namespace {

struct RoundTripCase {
  MeshFormat format;
  bool normals;
  bool colors;
};

class RoundTrip : public testing::TestWithParam<RoundTripCase> {};

TEST_P(RoundTrip, KeepsWhatTheFormatHolds) {
  const RoundTripCase& param = GetParam();
  const IndexedMesh mesh = TestMesh(param.normals, param.colors);
  const MeshFile read = ReadText(WriteText(mesh, param.format), param.format);
  if (param.format == MeshFormat::kStl) {
    // Vertices are numbered in the order of the facets.
    ASSERT_EQ(read.mesh.triangles.size(), mesh.triangles.size());
    ASSERT_EQ(read.mesh.positions.size(), mesh.positions.size());
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (int corner = 0; corner < 3; ++corner) {
        const Eigen::Vector3d expected =
            RoundedToFloat(mesh.positions[mesh.triangles[i][corner]]);
        EXPECT_EQ(read.mesh.positions[read.mesh.triangles[i][corner]],
                  expected);
      }
    }
    return;
  }
  EXPECT_TRUE(read.notes.empty());
  EXPECT_EQ(read.mesh.triangles, mesh.triangles);
  EXPECT_EQ(read.mesh.colors, mesh.colors);
  if (param.format != MeshFormat::kOff) {
    EXPECT_EQ(read.mesh.normals, mesh.normals);
  }
  ASSERT_EQ(read.mesh.positions.size(), mesh.positions.size());
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const Eigen::Vector3d expected = param.format == MeshFormat::kPly
                                         ? RoundedToFloat(mesh.positions[i])
                                         : mesh.positions[i];
    EXPECT_EQ(read.mesh.positions[i], expected);
  }
}

TEST(PlyRoundTrip, KeepsTheConfidence) {
  IndexedMesh mesh = TestMesh(true, true);
  EXPECT_TRUE(ReadText(WriteText(mesh, MeshFormat::kPly), MeshFormat::kPly)
                  .mesh.confidence.empty());
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.confidence.push_back(1 / float(1 + i));
  }
  const IndexedMesh read =
      ReadText(WriteText(mesh, MeshFormat::kPly), MeshFormat::kPly).mesh;
  EXPECT_EQ(read.confidence, mesh.confidence);
  EXPECT_EQ(read.colors, mesh.colors);
  EXPECT_EQ(read.triangles, mesh.triangles);
}

TEST(Write3mf, FailsWithTheStream) {
  std::ostream lost(nullptr);
  EXPECT_NO_THROW(Write3mf(TestMesh(true, true), lost));
  EXPECT_FALSE(lost.good());
}

TEST(Write3mf, RefusesSizesThatFilesCannotHold) {
  const auto error = [](double size) {
    IndexedMesh mesh = TestMesh(false, false);
    for (Eigen::Vector3d& position : mesh.positions) {
      position *= size;
    }
    std::ostringstream stream;
    try {
      Write3mf(mesh, stream);
    } catch (const Error& failure) {
      return std::string(failure.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(error(1), "none");
  EXPECT_THAT(error(1e-6), testing::HasSubstr("six decimals of a millimetre"));
  EXPECT_THAT(error(1e12), testing::HasSubstr("coordinates up to"));
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    RoundTrip,
    testing::Values(RoundTripCase{MeshFormat::kPly, false, false},
                    RoundTripCase{MeshFormat::kPly, true, false},
                    RoundTripCase{MeshFormat::kPly, false, true},
                    RoundTripCase{MeshFormat::kPly, true, true},
                    RoundTripCase{MeshFormat::kObj, false, false},
                    RoundTripCase{MeshFormat::kObj, true, false},
                    RoundTripCase{MeshFormat::kObj, false, true},
                    RoundTripCase{MeshFormat::kObj, true, true},
                    RoundTripCase{MeshFormat::kOff, false, false},
                    RoundTripCase{MeshFormat::kOff, true, true},
                    RoundTripCase{MeshFormat::kStl, true, true}));

TEST(MeshRoundTrip, PlyHasTheHeaderOfColmapsMeshers) {
  const std::string text = WriteText(TestMesh(true, true), MeshFormat::kPly);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 6\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 8\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(text.substr(0, header.size()), header);
  EXPECT_EQ(text.size(), header.size() + 6 * (6 * 4 + 3) + 8 * (1 + 3 * 4));
}

TEST(MeshRoundTrip, LargeMeshCrossesTheBuffers) {
  IndexedMesh mesh;
  for (int i = 0; i < 60000; ++i) {
    mesh.positions.emplace_back(i, 0.5 * i, -0.25 * i);
    mesh.triangles.push_back({static_cast<uint32_t>(i),
                              static_cast<uint32_t>((i * 7 + 1) % 60000),
                              static_cast<uint32_t>((i * 5 + 2) % 60000)});
  }
  for (const MeshFormat format :
       {MeshFormat::kPly, MeshFormat::kObj, MeshFormat::kOff}) {
    const MeshFile read = ReadText(WriteText(mesh, format), format);
    EXPECT_EQ(read.mesh.triangles, mesh.triangles);
    EXPECT_EQ(read.mesh.positions, mesh.positions);
  }
  const MeshFile stl =
      ReadText(WriteText(mesh, MeshFormat::kStl), MeshFormat::kStl);
  EXPECT_EQ(stl.mesh.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(stl.mesh.positions.size(), mesh.positions.size());
}

class CommaNumbers : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(MeshRoundTrip, CommaLocaleChangesNothing) {
  const IndexedMesh mesh = TestMesh(false, true);
  for (const MeshFormat format :
       {MeshFormat::kPly, MeshFormat::kObj, MeshFormat::kOff}) {
    const std::string expected = WriteText(mesh, format);
    const IndexedMesh read_before = ReadText(expected, format).mesh;
    const std::locale before = std::locale::global(
        std::locale(std::locale::classic(), new CommaNumbers));
    // Where the machine has such a locale, the functions of C follow it too.
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    const std::string text = WriteText(mesh, format);
    const IndexedMesh read = ReadText(text, format).mesh;
    std::locale::global(before);
    std::setlocale(LC_ALL, "C");
    EXPECT_EQ(text, expected);
    EXPECT_EQ(read.positions, read_before.positions);
  }
}

TEST(MeshRoundTrip, ThroughFilesByExtension) {
  const TemporaryFolder folder;
  const IndexedMesh mesh = TestMesh(true, true);
  for (const char* name : {"a.ply", "b.OBJ", "c.Off", "d.stl"}) {
    const std::filesystem::path path = folder.Path() / name;
    WriteMesh(path, mesh);
    const MeshFile read = ReadMesh(path);
    EXPECT_EQ(read.mesh.triangles.size(), mesh.triangles.size()) << name;
    EXPECT_EQ(read.mesh.positions.size(), mesh.positions.size()) << name;
  }
}

TEST(MeshRoundTrip, RefusesAttributesOfAnotherSize) {
  IndexedMesh mesh = TestMesh(true, false);
  mesh.normals.pop_back();
  std::ostringstream stream;
  EXPECT_THROW(WriteMesh(stream, MeshFormat::kPly, mesh), InvariantError);
}

}  // namespace
}  // namespace octacut
