#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "colmap_io/files/read_file.h"
#include "core/base/error.h"
#include "tests/colmap_io/mesh/test_meshes.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(MeshPath, UnknownExtensionIsAnOptionError) {
  for (const char* name : {"mesh.xyz", "mesh", "ply", ".ply"}) {
    EXPECT_THAT([&] { CheckMeshPath(name); },
                ThrowsMessage<OptionError>(
                    testing::AllOf(HasSubstr(name), HasSubstr(".stl"))));
  }
  EXPECT_THROW(WriteMesh("mesh.xyz", TestMesh(false, false)), OptionError);
}

TEST(MeshPath, MissingFolderIsNamed) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "missing" / "a.ply";
  const auto names_it = ThrowsMessage<InputError>(HasSubstr(path.string()));
  EXPECT_THAT([&] { CheckMeshPath(path); }, names_it);
  EXPECT_THAT([&] { WriteMesh(path, TestMesh(false, false)); }, names_it);
}

TEST(MeshPath, UnwritableFolderIsNamed) {
  const TemporaryFolder folder;
  fs::permissions(folder.Path(), fs::perms::owner_read | fs::perms::owner_exec);
  // Root may write everywhere but there.
  const fs::path path =
      (::geteuid() == 0 ? fs::path("/proc") : folder.Path()) / "a.ply";
  EXPECT_THAT([&] { CheckMeshPath(path); },
              ThrowsMessage<InputError>(HasSubstr(path.string())));
}

TEST(MeshPath, FolderOrDeviceInPlaceOfTheFileIsRefused) {
  const TemporaryFolder folder;
  fs::create_directory(folder.Path() / "a.ply");
  EXPECT_THROW(CheckMeshPath(folder.Path() / "a.ply"), InputError);
  fs::create_symlink("/dev/null", folder.Path() / "b.ply");
  EXPECT_THROW(CheckMeshPath(folder.Path() / "b.ply"), InputError);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(MeshPath, CheckLeavesNothingAndTouchesNothing) {
  const TemporaryFolder folder;
  CheckMeshPath(folder.Path() / "a.ply");
  EXPECT_EQ(folder.NumFiles(), 0u);
  std::ofstream(folder.Path() / "b.ply") << "precious";
  CheckMeshPath(folder.Path() / "b.ply");
  EXPECT_EQ(folder.NumFiles(), 1u);
  EXPECT_EQ(ReadFile(folder.Path() / "b.ply"), "precious");
}

TEST(MeshPath, WriteReplacesAndLeavesNoTemporary) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "a.off";
  std::ofstream(path) << "old";
  WriteMesh(path, TestMesh(false, false));
  EXPECT_EQ(folder.NumFiles(), 1u);
  EXPECT_EQ(ReadMesh(path).mesh.triangles.size(), 8u);
}

TEST(MeshPath, WriteThroughASymbolicLinkReplacesItsTarget) {
  const TemporaryFolder folder;
  fs::create_directory(folder.Path() / "elsewhere");
  const fs::path target = folder.Path() / "elsewhere" / "real.ply";
  std::ofstream(target) << "old";
  fs::create_symlink(target, folder.Path() / "a.ply");
  WriteMesh(folder.Path() / "a.ply", TestMesh(false, false));
  EXPECT_TRUE(fs::is_symlink(folder.Path() / "a.ply"));
  EXPECT_EQ(ReadMesh(target).mesh.triangles.size(), 8u);
}

TEST(MeshPath, MissingFileAndFolderAreNamedOnReading) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { ReadMesh(folder.Path() / "none.ply"); },
              ThrowsMessage<InputError>(HasSubstr("none.ply")));
  EXPECT_THROW(ReadMesh(folder.Path()), InputError);
}

TEST(MeshPath, PlyIsKnownByItsContents) {
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "mesh.txt";
  std::ofstream(path) << WriteText(TestMesh(false, false), MeshFormat::kPly);
  EXPECT_EQ(ReadMesh(path).mesh.triangles.size(), 8u);
}

TEST(MeshPath, MeshesComeThroughPipes) {
  const TemporaryFolder folder;
  for (const auto& [name, format] : {std::pair("p.ply", MeshFormat::kPly),
                                     std::pair("p.obj", MeshFormat::kObj)}) {
    const fs::path path = folder.Path() / name;
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    std::thread writer([&] {
      std::ofstream(path) << WriteText(TestMesh(false, false), format);
    });
    const IndexedMesh mesh = ReadMesh(path).mesh;
    writer.join();
    EXPECT_EQ(mesh.triangles.size(), 8u) << name;
  }
}

}  // namespace
}  // namespace octacut
