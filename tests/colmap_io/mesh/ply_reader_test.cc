#include <gmock/gmock.h>

#include <bit>
#include <stdexcept>
#include <streambuf>

#include "core/base/error.h"
#include "tests/colmap_io/mesh/test_meshes.h"

namespace octacut {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Triangle = std::array<uint32_t, 3>;
using Color = std::array<uint8_t, 3>;

// Appends the bytes of a value, most significant first if `big`.
template <typename T>
void Put(std::string* text, T value, bool big) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if (big == (std::endian::native == std::endian::little)) {
    std::reverse(bytes, bytes + sizeof(T));
  }
  text->append(bytes, sizeof(T));
}

TEST(PlyReader, AsciiWithEverythingOthersWrite) {
  const MeshFile file = ReadText(
      "ply\r\n"
      "comment made by hand\r\n"
      "format ascii 1.0\r\n"
      "obj_info some scanner\r\n"
      "element face 2\r\n"
      "property uchar flags\r\n"
      "property list uint8 int32 vertex_index\r\n"
      "property list uchar float texcoord\r\n"
      "element camera 1\r\n"
      "property float view_px\r\n"
      "property list int double k\r\n"
      "element nothing 7\r\n"
      "element vertex 5\r\n"
      "property double quality\r\n"
      "property float64 z\r\n"
      "property int16 y\r\n"
      "property float x\r\n"
      "property list uchar int rings\r\n"
      "property uchar diffuse_red\r\n"
      "property uchar diffuse_green\r\n"
      "property uchar diffuse_blue\r\n"
      "property uchar alpha\r\n"
      "element edge 1\r\n"
      "property int vertex1\r\n"
      "end_header\r\n"
      "255 3 0 1 2 6 0 0 1 0 1 1\r\n"
      "0 4 0 1 2 3 0\r\n"
      "1.5 2 0.5 -0.5\r\n"
      "9 0 0 0 0 1 2 3 255\r\n"
      "9 0.5 0 1 2 7 8 4 5 6 255\r\n"
      "9 0 2 +1e0 0 7 8 9 255\r\n"
      "9 0 1 0 0 10 11 12 255\r\n"
      "nan 0 7 -0.25 0 13 14 15 255\r\n"
      "3",
      MeshFormat::kPly);
  ASSERT_EQ(file.mesh.positions.size(), 5u);
  EXPECT_EQ(file.mesh.positions[1], Eigen::Vector3d(1, 0, 0.5));
  EXPECT_EQ(file.mesh.positions[4], Eigen::Vector3d(-0.25, 7, 0));
  EXPECT_EQ(file.mesh.triangles.size(), 3u);
  EXPECT_EQ(file.mesh.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(file.mesh.colors[4], (Color{13, 14, 15}));
  EXPECT_TRUE(file.mesh.normals.empty());
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_THAT(file.notes[0], HasSubstr("more than three corners"));
}

class BinaryPly : public testing::TestWithParam<bool> {};

TEST_P(BinaryPly, EveryTypeInEitherOrder) {
  const bool big = GetParam();
  std::string text =
      std::string("ply\nformat ") +
      (big ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\n"
      "element range_grid 2\nproperty list short ushort points\n"
      "element vertex 4\n"
      "property short a\nproperty double x\nproperty float y\nproperty char z\n"
      "property list uint double extra\n"
      "property ushort red\nproperty ushort green\nproperty ushort blue\n"
      "property double nx\nproperty float ny\nproperty int nz\n"
      "element face 2\n"
      "property list int ushort vertex_indices\nproperty uint label\n"
      "end_header\n";
  for (const int count : {2, 0}) {
    Put<int16_t>(&text, static_cast<int16_t>(count), big);
    for (int i = 0; i < count; ++i) {
      Put<uint16_t>(&text, 77, big);
    }
  }
  for (int i = 0; i < 4; ++i) {
    Put<int16_t>(&text, -1, big);
    Put<double>(&text, 0.1 * i, big);
    Put<float>(&text, i == 1 ? 2.5f : 0.f, big);
    Put<int8_t>(&text, static_cast<int8_t>(-i), big);
    Put<uint32_t>(&text, i == 2 ? 1 : 0, big);
    if (i == 2) {
      Put<double>(&text, 1e300, big);
    }
    Put<uint16_t>(&text, 65535, big);
    Put<uint16_t>(&text, 257, big);
    Put<uint16_t>(&text, 0, big);
    Put<double>(&text, 0, big);
    Put<float>(&text, 0, big);
    Put<int32_t>(&text, -1, big);
  }
  for (int i = 0; i < 2; ++i) {
    Put<int32_t>(&text, 3, big);
    for (int corner = 0; corner < 3; ++corner) {
      Put<uint16_t>(&text, static_cast<uint16_t>(corner + i), big);
    }
    Put<uint32_t>(&text, 0xffffffffu, big);
  }
  const MeshFile file = ReadText(text, MeshFormat::kPly);
  EXPECT_THAT(file.mesh.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{1, 2, 3}));
  EXPECT_EQ(file.mesh.positions[1], Eigen::Vector3d(0.1, 2.5, -1));
  EXPECT_EQ(file.mesh.colors[3], (Color{255, 1, 0}));
  EXPECT_EQ(file.mesh.normals[3], Eigen::Vector3f(0, 0, -1));
  EXPECT_TRUE(file.notes.empty());

  // Every shorter file is an error, never a crash or a partial mesh.
  for (size_t size = 0; size < text.size(); ++size) {
    EXPECT_NE(ReadError(text.substr(0, size), MeshFormat::kPly), "") << size;
  }
}

INSTANTIATE_TEST_SUITE_P(Endianness, BinaryPly, testing::Bool());

std::string Ascii(const std::string& elements, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

const std::string kXyz =
    "property float x\nproperty float y\nproperty float z\n";

TEST(PlyReader, FloatColorsAndBadNormals) {
  const MeshFile file = ReadText(
      Ascii("element vertex 2\n" + kXyz +
                "property float nx\nproperty float ny\nproperty float nz\n"
                "property float red\nproperty float green\n"
                "property float blue\n",
            "0 0 0 nan 0 1 1 0.5 0\n1 1 1 0 0 1 0 nan 0.2"),
      MeshFormat::kPly);
  EXPECT_THAT(file.mesh.colors,
              ElementsAre(Color{255, 128, 0}, Color{0, 0, 51}));
  EXPECT_EQ(file.mesh.normals[0], Eigen::Vector3f::Zero());
  EXPECT_EQ(file.mesh.normals[1], Eigen::Vector3f::UnitZ());
  EXPECT_THAT(file.notes, ElementsAre(HasSubstr("1 vertex normals")));
}

TEST(PlyReader, PointsOnlyAndEmptyAreAccepted) {
  EXPECT_EQ(
      ReadText(Ascii("element vertex 1\n" + kXyz, "1 2 3"), MeshFormat::kPly)
          .mesh.positions.size(),
      1u);
  EXPECT_TRUE(
      ReadText(Ascii("element vertex 0\n" + kXyz + "element face 0\n", ""),
               MeshFormat::kPly)
          .mesh.positions.empty());
}

// COLMAP 3.8's poisson_mesher writes such vertices.
TEST(PlyReader, LeavesOutVerticesThatAreNotFinite) {
  const MeshFile file =
      ReadText(Ascii("element vertex 6\n" + kXyz +
                         "property uchar red\nproperty uchar green\n"
                         "property uchar blue\nelement face 3\n"
                         "property list uchar int vertex_indices\n",
                     "0 0 0 0 0 0\nnan 0 0 1 1 1\n1 0 0 2 2 2\n0 1 0 3 3 3\n"
                     "0 0 -inf 4 4 4\n1 1 0 5 5 5\n"
                     "3 0 2 3\n3 0 1 2\n4 3 2 5 4\n"),
               MeshFormat::kPly);
  EXPECT_THAT(file.mesh.positions,
              ElementsAre(Eigen::Vector3d(0, 0, 0),
                          Eigen::Vector3d(1, 0, 0),
                          Eigen::Vector3d(0, 1, 0),
                          Eigen::Vector3d(1, 1, 0)));
  EXPECT_THAT(
      file.mesh.colors,
      ElementsAre(
          Color{0, 0, 0}, Color{2, 2, 2}, Color{3, 3, 3}, Color{5, 5, 5}));
  EXPECT_THAT(file.mesh.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(file.notes,
              ElementsAre("2 vertices whose coordinates are not finite, and "
                          "the 2 faces at them, are left out"));
}

TEST(PlyReader, TriangleStrips) {
  const MeshFile file =
      ReadText(Ascii("element vertex 5\n" + kXyz +
                         "element tristrips 1\n"
                         "property list int int vertex_indices\n",
                     "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0\n8 0 1 2 3 -1 2 3 4"),
               MeshFormat::kPly);
  EXPECT_THAT(
      file.mesh.triangles,
      ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}, Triangle{2, 3, 4}));
}

TEST(PlyReader, ErrorsNameTheElement) {
  const std::string faces =
      "element face 2\nproperty list uchar int vertex_indices\n";
  const auto error = [](const std::string& elements, const std::string& body) {
    return ReadError(Ascii(elements, body), MeshFormat::kPly);
  };
  const std::string two = "element vertex 2\n" + kXyz;
  EXPECT_THAT(error(two, "0 nan 0 1 inf 1"), HasSubstr("no vertex has finite"));
  EXPECT_THAT(error(two + faces, "nan 0 0 1 1 1 3 0 1 1 3 1 1 2"),
              HasSubstr("face 1: vertex index 2 is out of range, there are 2"));
  EXPECT_THAT(error(two, "0 0 0 1 1x 1"), HasSubstr("vertex 1: \"1x\""));
  EXPECT_THAT(error(two, "0.0 0.0 0.0 0.0"), HasSubstr("vertex 1: the file"));
  EXPECT_THAT(error(two + faces, "0 0 0 1 1 1 3 0 1 1 3 0 1 2"),
              HasSubstr("test: face 1: vertex index 2 is out of range"));
  EXPECT_THAT(error(two + faces, "0 0 0 1 1 1 3 0 1 1 3 0 1 -1"),
              HasSubstr("face 1: vertex index -1"));
  EXPECT_THAT(error(two + faces, "0 0 0 1 1 1 3 0 1.5 1 3 0 1 1"),
              HasSubstr("face 0: vertex index 1.5"));
  EXPECT_THAT(error(two + faces, "0 0 0 1 1 1 -3 0 1 1 3 0 1 1"),
              HasSubstr("face 0: list vertex_indices has the length -3"));
  EXPECT_THAT(error("element vertex 1\nproperty float x\n", "0"),
              HasSubstr("x, y and z"));
  EXPECT_THAT(error("element face 1\nproperty int a\n", "0"),
              HasSubstr("vertex_indices"));
  EXPECT_THAT(error("", ""), HasSubstr("no element vertex"));
  EXPECT_THAT(error(two + "property float confidence\n", "0 0 0 1 1 1 1 nan"),
              HasSubstr("vertex 1: confidence is not finite"));
}

TEST(PlyReader, ErrorsOfTheHeader) {
  const auto error = [](const std::string& text) {
    return ReadError(text, MeshFormat::kPly);
  };
  EXPECT_THAT(error(""), HasSubstr("not a PLY file"));
  EXPECT_THAT(error("solid\n"), HasSubstr("not a PLY file"));
  EXPECT_THAT(error("ply\nformat ascii 1.0\nelement vertex 0\n"),
              HasSubstr("no end"));
  EXPECT_THAT(error("ply\nend_header\n"), HasSubstr("no format"));
  EXPECT_THAT(error("ply\nformat utf7 1.0\n"), HasSubstr("line 2"));
  EXPECT_THAT(error(Ascii("element vertex -1\n", "")), HasSubstr("\"-1\""));
  EXPECT_THAT(error(Ascii("element vertex 1\nproperty quad x\n", "")),
              HasSubstr("line 4: unknown property type \"quad\""));
  EXPECT_THAT(error(Ascii("property float x\n", "")),
              HasSubstr("before any element"));
  EXPECT_THAT(error(Ascii("elephant\n", "")), HasSubstr("elephant"));
}

TEST(PlyReader, CountsAreCheckedBeforeMemoryIsTaken) {
  const std::string faces =
      "element face 4000000000\nproperty list uchar int vertex_indices\n";
  for (const char* format : {"ascii", "binary_little_endian"}) {
    const std::string head = "ply\nformat " + std::string(format) + " 1.0\n";
    EXPECT_THAT(ReadError(head + "element vertex 4000000000\n" + kXyz +
                              "end_header\n0 0 0\n",
                          MeshFormat::kPly),
                HasSubstr("announced"));
    EXPECT_THAT(ReadError(head + "element vertex 99999999999999999\n" + kXyz +
                              "end_header\n0 0 0\n",
                          MeshFormat::kPly),
                HasSubstr("count"));
    EXPECT_THAT(
        ReadError(head + faces + "end_header\n0 0 0\n", MeshFormat::kPly),
        HasSubstr("announced"));
  }
  EXPECT_THAT(
      ReadError(Ascii("element face 1\nproperty list int int vertex_index\n",
                      "2000000000 1 2 3"),
                MeshFormat::kPly),
      HasSubstr("only"));
}

// A stream that cannot seek, as a pipe.
class PipeBuffer : public std::streambuf {
 public:
  explicit PipeBuffer(std::string text) : text_(std::move(text)) {
    setg(text_.data(), text_.data(), text_.data() + text_.size());
  }

 private:
  std::string text_;
};

// A file of which the disk cannot read the rest.
class BadBuffer : public PipeBuffer {
 public:
  using PipeBuffer::PipeBuffer;

 protected:
  int_type underflow() override { throw std::runtime_error("input/output"); }
};

TEST(MeshReaders, AReadErrorIsNoEndOfTheFile) {
  for (const MeshFormat format :
       {MeshFormat::kPly, MeshFormat::kObj, MeshFormat::kOff}) {
    BadBuffer bad(WriteText(TestMesh(false, false), format));
    std::istream stream(&bad);
    EXPECT_THAT(
        [&] { ReadMesh(stream, format, "disk"); },
        testing::ThrowsMessage<InputError>(HasSubstr("disk: cannot be read")));
  }
}

TEST(PlyReader, ReadsStreamsThatCannotSeek) {
  PipeBuffer whole(WriteText(TestMesh(true, true), MeshFormat::kPly));
  std::istream stream(&whole);
  EXPECT_EQ(ReadMesh(stream, MeshFormat::kPly, "pipe").mesh.triangles.size(),
            8u);
  PipeBuffer lying(
      "ply\nformat binary_little_endian 1.0\n"
      "element vertex 4000000000\n" +
      kXyz + "end_header\n0123456789abcdef");
  std::istream lying_stream(&lying);
  EXPECT_THROW(ReadMesh(lying_stream, MeshFormat::kPly, "pipe"), InputError);
}

}  // namespace
}  // namespace octacut
