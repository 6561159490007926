// Damaged files must end in a mesh or in an InputError, never otherwise.
#include <random>

#include "core/base/error.h"
#include "tests/colmap_io/mesh/test_meshes.h"

namespace octacut {
namespace {

std::vector<std::pair<MeshFormat, std::string>> Seeds() {
  const IndexedMesh mesh = TestMesh(true, true);
  std::vector<std::pair<MeshFormat, std::string>> seeds;
  for (const MeshFormat format : {MeshFormat::kPly,
                                  MeshFormat::kObj,
                                  MeshFormat::kOff,
                                  MeshFormat::kStl}) {
    seeds.emplace_back(format, WriteText(mesh, format));
  }
  seeds.emplace_back(
      MeshFormat::kPly,
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
      "property float y\nproperty float z\nproperty list int int more\n"
      "element face 2\nproperty list uchar int vertex_indices\n"
      "element tristrips 1\nproperty list int int vertex_indices\n"
      "end_header\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 2 1 2\n0 2 0 0\n"
      "5 0 1 2 4 3\n3 0 1 2\n5 0 1 2 -1 3\n");
  seeds.emplace_back(MeshFormat::kStl,
                     "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                     "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid");
  return seeds;
}

// True when it could be read; fails the test for anything but an InputError.
bool Try(const std::string& text, MeshFormat format) {
  try {
    const MeshFile file = ReadText(text, format);
    for (const std::array<uint32_t, 3>& triangle : file.mesh.triangles) {
      for (const uint32_t vertex : triangle) {
        EXPECT_LT(vertex, file.mesh.positions.size());
      }
    }
    for (const Eigen::Vector3d& position : file.mesh.positions) {
      EXPECT_TRUE(position.allFinite());
    }
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 5), "test:");
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return false;
  }
}

TEST(MeshFuzz, Truncation) {
  for (const auto& [format, text] : Seeds()) {
    ASSERT_TRUE(Try(text, format));
    size_t num_refused = 0;
    for (size_t size = 0; size < text.size(); ++size) {
      num_refused += !Try(text.substr(0, size), format);
    }
    EXPECT_GT(num_refused, 0u);
  }
}

TEST(MeshFuzz, Corruption) {
  std::mt19937 random(7);
  for (const auto& [format, text] : Seeds()) {
    size_t num_refused = 0;
    for (int trial = 0; trial < 4000; ++trial) {
      std::string damaged = text;
      const int num_changes = 1 + static_cast<int>(random() % 4);
      for (int change = 0; change < num_changes; ++change) {
        const size_t at = random() % damaged.size();
        switch (random() % 4) {
          case 0:
            damaged[at] = static_cast<char>(random() & 0xff);
            break;
          case 1:
            damaged[at] = "0123456789-+. \n#eE"[random() % 18];
            break;
          case 2:
            damaged.erase(at, 1 + random() % 8);
            break;
          default:
            damaged.insert(at, damaged.substr(random() % damaged.size(), 12));
        }
        if (damaged.empty()) {
          damaged.push_back(' ');
        }
      }
      num_refused += !Try(damaged, format);
    }
    EXPECT_GT(num_refused, 100u);
  }
}

TEST(MeshFuzz, OneFormatReadAsAnother) {
  for (const auto& [written, text] : Seeds()) {
    for (const MeshFormat format : {MeshFormat::kPly,
                                    MeshFormat::kObj,
                                    MeshFormat::kOff,
                                    MeshFormat::kStl}) {
      EXPECT_EQ(Try(text, format), format == written);
    }
  }
}

}  // namespace
}  // namespace octacut
