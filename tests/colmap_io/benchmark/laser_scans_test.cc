#include "colmap_io/benchmark/laser_scans.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "core/base/error.h"
#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string Project(const std::string& matrix) {
  return "<!DOCTYPE MeshLabDocument>\n<MeshLabProject>\n <MeshGroup>\n"
         "  <MLMesh label=\"a\" filename=\"a.obj\">\n   <MLMatrix44>\n1 0 0 0 "
         "\n0 1 0 0 \n0 0 1 0 \n0 0 0 1 \n</MLMatrix44>\n  </MLMesh>\n"
         "  <MLMesh label=\"b\" filename=\"b.obj\">\n   <MLMatrix44>" +
         matrix +
         "</MLMatrix44>\n  </MLMesh>\n </MeshGroup>\n <RasterGroup/>\n"
         "</MeshLabProject>\n";
}

TEST(ReadLaserScans, ScansWithTheirPoses) {
  const TemporaryFolder folder;
  folder.Write("a.obj", "v 1 2 3\n");
  folder.Write("b.obj", "v 1 0 0\nv 0 1 0\n");
  // A quarter of a turn about z, then a shift.
  const std::string path =
      folder.Write("scans.mlp", Project("0 -1 0 10 1 0 0 20 0 0 1 30 0 0 0 1"));
  const std::vector<LaserScan> scans = ReadLaserScans(path);
  ASSERT_EQ(scans.size(), 2u);
  const std::vector<Eigen::Vector3d> merged = MergeScans(scans);
  ASSERT_EQ(merged.size(), 3u);
  EXPECT_EQ(merged[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(merged[1], Eigen::Vector3d(10, 21, 30));
  EXPECT_EQ(merged[2], Eigen::Vector3d(9, 20, 30));
}

TEST(ReadLaserScans, MistakesAreNamed) {
  const TemporaryFolder folder;
  folder.Write("a.obj", "v 1 2 3\n");
  const std::string identity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
  const std::pair<std::string, const char*> cases[] = {
      {"<a>", "cannot be read as a MeshLab project"},
      {"<MeshLabProject/>", "no MLMesh"},
      {Project("1 2 3"), "MLMesh 1: MLMatrix44 must hold 16 numbers"},
      {Project("2" + identity.substr(1)), "must be a rotation"},
      {Project(identity), "b.obj: cannot be opened"},
  };
  for (const auto& mistake : cases) {
    const auto path = folder.Write("p.mlp", mistake.first);
    EXPECT_THAT([&] { ReadLaserScans(path); },
                ThrowsMessage<InputError>(HasSubstr(mistake.second)));
  }
}

}  // namespace
}  // namespace octacut
