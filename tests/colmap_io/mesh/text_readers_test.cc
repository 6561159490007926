#include <gmock/gmock.h>

#include "core/base/error.h"
#include "tests/colmap_io/mesh/test_meshes.h"

namespace octacut {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Triangle = std::array<uint32_t, 3>;
using Color = std::array<uint8_t, 3>;

TEST(ObjReader, EveryFormOfAFace) {
  const MeshFile file = ReadText(
      "# a comment\nmtllib a.mtl\no thing\n\n"
      "v 0 0 0\nv 1.0 0 0 # one\r\nv 0 +1 0 1.0\nv 1 1 0\n"
      "vt 0 0\nvt 1 0\n"
      "vn 0 0 2\nvn 0 1 0\n"
      "g group\nusemtl red\ns off\n"
      "f 1 2 3\nf 1/1 2/2 3/1\nf 1//1 2//1 3//2\nf 1/1/1 2/2/1 3/1/2 # x\n"
      "f -4 -3 -2\nf -4//-2 -3//-2 -2//-1\n"
      "f 1 2 \\\n 4 \\\n 3\n"
      "l 1 2\np 1\n",
      MeshFormat::kObj);
  ASSERT_EQ(file.mesh.triangles.size(), 8u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(file.mesh.triangles[i], (Triangle{0, 1, 2})) << i;
  }
  EXPECT_EQ(file.mesh.positions[2], Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(file.mesh.normals[0], Eigen::Vector3f::UnitZ());
  EXPECT_EQ(file.mesh.normals[2], Eigen::Vector3f::UnitY());
  EXPECT_EQ(file.mesh.normals[3], Eigen::Vector3f::Zero());
  EXPECT_TRUE(file.mesh.colors.empty());
}

TEST(ObjReader, SkipsAByteOrderMark) {
  const IndexedMesh mesh = ReadText(
                               "\xEF\xBB\xBFv 5 0 0\nv 1 0 0\nv 0 1 0\n"
                               "f 1 2 3\n",
                               MeshFormat::kObj)
                               .mesh;
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions[0], Eigen::Vector3d(5, 0, 0));
}

TEST(ObjReader, NegativeIndicesCountFromTheLine) {
  const MeshFile file = ReadText(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n"
      "v 0 0 1\nv 1 0 1\nv 0 1 1\nf -3 -2 -1\n",
      MeshFormat::kObj);
  EXPECT_THAT(file.mesh.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{3, 4, 5}));
}

TEST(ObjReader, ColorsOfBothScales) {
  EXPECT_THAT(ReadText("v 0 0 0 1 0.5 0\nv 0 0 0 0 0 1\n", MeshFormat::kObj)
                  .mesh.colors,
              ElementsAre(Color{255, 128, 0}, Color{0, 0, 255}));
  EXPECT_THAT(ReadText("v 0 0 0 255 7 0\nv 0 0 0 1 1 1\n", MeshFormat::kObj)
                  .mesh.colors,
              ElementsAre(Color{255, 7, 0}, Color{1, 1, 1}));
  const MeshFile partly =
      ReadText("v 0 0 0 1 1 1\nv 0 0 0\n", MeshFormat::kObj);
  EXPECT_TRUE(partly.mesh.colors.empty());
  EXPECT_THAT(partly.notes, ElementsAre(HasSubstr("colours")));
}

TEST(ObjReader, CoordinatesThatNoFloatHolds) {
  try {
    ReadText("v 0 0 0\nv 0 -1e39 0\nv 1 0 0\nf 1 2 3\n", MeshFormat::kObj);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("vertex 1: a coordinate of 1e+39"));
  }
}

TEST(ObjReader, ErrorsNameTheLine) {
  const auto error = [](const std::string& text) {
    return ReadError("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + text, MeshFormat::kObj);
  };
  EXPECT_THAT(error("v 1 2\n"), HasSubstr("test: line 4: vertex has 2"));
  EXPECT_THAT(error("v 1 2 nan\n"), HasSubstr("line 4: coordinates"));
  EXPECT_THAT(error("v 1 2 x\n"), HasSubstr("line 4: \"x\""));
  EXPECT_THAT(error("f 1 2 0\n"), HasSubstr("line 4: face has a bad corner"));
  EXPECT_THAT(error("f 1 2 -4\n"), HasSubstr("line 4: face has a bad corner"));
  EXPECT_THAT(error("f 1 2 /3\n"), HasSubstr("line 4: face has a bad corner"));
  EXPECT_THAT(error("f 1 2 3\nf 1 2 4\n"),
              HasSubstr("face 1: vertex index 3 is out of range"));
  EXPECT_THAT(error("f 1 2 99999999999999999999\n"), HasSubstr("line 4"));
  EXPECT_THAT(ReadError("# nothing\n", MeshFormat::kObj),
              HasSubstr("no vertices"));
}

TEST(OffReader, CommentsPolygonsAndFaceColors) {
  const MeshFile file = ReadText(
      "# made by hand\nOFF # keyword\n\n 5 2 0 # counts\n"
      "0 0 0\n1 0 0 # a vertex\n\n1 1 0\n0 1 0\n5 5 5\n"
      "4 0 1 2 3 255 0 0\n3 0 1 4 0.5 0.5 0.5\n",
      MeshFormat::kOff);
  EXPECT_EQ(file.mesh.positions.size(), 5u);
  ASSERT_EQ(file.mesh.triangles.size(), 3u);
  EXPECT_EQ(file.mesh.triangles[2], (Triangle{0, 1, 4}));
  EXPECT_TRUE(file.mesh.colors.empty());
}

TEST(TextReaders, SkipAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  EXPECT_EQ(ReadText(mark + "OFF\n1 0 0\n1 2 3\n", MeshFormat::kOff)
                .mesh.positions.size(),
            1u);
  EXPECT_EQ(ReadText(mark + "solid\nfacet\nouter loop\nvertex 0 0 0\n"
                            "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n",
                     MeshFormat::kStl)
                .mesh.triangles.size(),
            1u);
}

TEST(OffReader, Prefixes) {
  EXPECT_EQ(ReadText("OFF 1 0 0\n1 2 3\n", MeshFormat::kOff).mesh.positions[0],
            Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(ReadText("1 0 0\n1 2 3\n", MeshFormat::kOff).mesh.positions[0],
            Eigen::Vector3d(1, 2, 3));
  EXPECT_THAT(ReadText("COFF\n1 0 0\n1 2 3 255 1 0 255\n", MeshFormat::kOff)
                  .mesh.colors,
              ElementsAre(Color{255, 1, 0}));
  EXPECT_THAT(ReadText("COFF\n1 0 0\n1 2 3 1.0 0.2 0. 1.\n", MeshFormat::kOff)
                  .mesh.colors,
              ElementsAre(Color{255, 51, 0}));
  const MeshFile both =
      ReadText("STCNOFF\n1 0 0\n1 2 3 0 0 1 9 8 7 255 0 0\n", MeshFormat::kOff);
  EXPECT_THAT(both.mesh.colors, ElementsAre(Color{9, 8, 7}));
  EXPECT_EQ(both.mesh.normals[0], Eigen::Vector3f::UnitZ());
}

TEST(OffReader, Errors) {
  const auto error = [](const std::string& text) {
    return ReadError(text, MeshFormat::kOff);
  };
  EXPECT_THAT(error(""), HasSubstr("empty"));
  EXPECT_THAT(error("OFF BINARY\n"), HasSubstr("text OFF"));
  EXPECT_THAT(error("4OFF\n1 0 0\n"), HasSubstr("text OFF"));
  EXPECT_THAT(error("OFF\n"), HasSubstr("counts"));
  EXPECT_THAT(error("OFF\n-1 2 0\n"), HasSubstr("counts"));
  EXPECT_THAT(error("OFF\n4000000000 0 0\n0 0 0\n"), HasSubstr("announced"));
  EXPECT_THAT(error("OFF\n2 0 0\n0.00 0.00 0.00\n"),
              HasSubstr("vertex 1 of 2"));
  EXPECT_THAT(error("OFF\n1 0 0\n0 0 nan\n"), HasSubstr("line 3: vertex 0"));
  EXPECT_THAT(error("OFF\n1 1 0\n0 0 0\n3 0 0 1\n"), HasSubstr("face 0"));
  EXPECT_THAT(error("OFF\n1 1 0\n0 0 0\n3 0 0 -1\n"), HasSubstr("face 0"));
  EXPECT_THAT(error("OFF\n1 1 0\n0 0 0\n3 0 0\n"), HasSubstr("face 0"));
  EXPECT_THAT(error("OFF\n1 2 0\n0 0 0\n3 0 0 0\n"), HasSubstr("face 1 of 2"));
}

TEST(StlReader, TextIsWelded) {
  const std::string text =
      "solid two words\n"
      " facet normal 0 0 1\n  outer loop\n"
      "   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1e0 -0.0\n"
      "  endloop\n endfacet\n"
      " FACET NORMAL 0 0 1\n  OUTER LOOP\n"
      "   VERTEX 1 0 0\n   VERTEX 1 1 0\n   VERTEX 0 1 0\n"
      "  ENDLOOP\n ENDFACET\n"
      "endsolid\n";
  const MeshFile file = ReadText(text, MeshFormat::kStl);
  EXPECT_EQ(file.mesh.positions.size(), 4u);
  EXPECT_THAT(file.mesh.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{1, 3, 2}));
  for (const size_t cut : {40u, 90u, 110u}) {
    EXPECT_NE(ReadError(text.substr(0, cut), MeshFormat::kStl), "") << cut;
  }
  EXPECT_THAT(ReadError("solid\nvertex 0 0 0\n", MeshFormat::kStl),
              HasSubstr("line 2: vertex outside"));
  EXPECT_THAT(
      ReadError("solid\nfacet\nouter loop\nvertex 0 nan 0\n", MeshFormat::kStl),
      HasSubstr("facet 0"));
}

TEST(StlReader, BinaryThatBeginsLikeText) {
  std::string text = WriteText(TestMesh(false, false), MeshFormat::kStl);
  text.replace(0, 6, "solid ");
  EXPECT_EQ(ReadText(text, MeshFormat::kStl).mesh.triangles.size(), 8u);
}

// Its facets are fewer than announced.
TEST(StlReader, CutBinaryThatBeginsLikeText) {
  std::string text = WriteText(TestMesh(false, false), MeshFormat::kStl);
  text.replace(0, 5, "solid");
  EXPECT_THAT(ReadError(text.substr(0, text.size() - 60), MeshFormat::kStl),
              HasSubstr("facets announced"));
}

TEST(StlReader, BinaryErrors) {
  const std::string text = WriteText(TestMesh(false, false), MeshFormat::kStl);
  EXPECT_THAT(ReadError(text.substr(0, 70), MeshFormat::kStl),
              HasSubstr("header"));
  EXPECT_THAT(ReadError(text.substr(0, text.size() - 1), MeshFormat::kStl),
              HasSubstr("facet 7: the file ends"));
  std::string broken = text;
  broken.replace(84 + 50 + 12, 4, "\xff\xff\xff\xff");
  EXPECT_THAT(ReadError(broken, MeshFormat::kStl), HasSubstr("facet 1"));
}

}  // namespace
}  // namespace octacut
