#include "plugin/file_roles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "colmap_io/files/read_file.h"
#include "core/base/error.h"
#include "tests/plugin/run_octacut.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class FileRolesTest : public ::testing::Test {
 protected:
  void ExpectRefused(const fs::path& path, const std::string& message) {
    EXPECT_THAT([&] { files_.Write("output_path", path, "the output"); },
                ThrowsMessage<OptionError>(HasSubstr(message)));
  }

  TemporaryFolder folder_;
  FileRoles files_;
};

TEST_F(FileRolesTest, WhatIsReadIsNotWritten) {
  const std::string mesh = folder_.Write("mesh.ply", "precious");
  fs::create_symlink(mesh, folder_ / "link.ply");
  files_.Read(mesh, "the mesh");
  ExpectRefused(
      mesh,
      "output_path = " + mesh + ": must not be the same file as the mesh");
  ExpectRefused(fs::path(folder_ / ".") / "mesh.ply", "the same file");
  ExpectRefused(folder_ / "link.ply", "the same file as the mesh");
  EXPECT_EQ(ReadFile(mesh), "precious");
}

TEST_F(FileRolesTest, NothingIsWrittenTwice) {
  files_.Write("output_path", folder_ / "new.html", "the report");
  ExpectRefused(folder_ / "new.html", "the same file as the report");
  EXPECT_NO_THROW(files_.Write("html_path", folder_ / "page.html", "the page"));
  EXPECT_FALSE(fs::exists(folder_ / "new.html"));
}

TEST_F(FileRolesTest, EmptyPathsAreNoFiles) {
  files_.Read("", "the mesh");
  EXPECT_NO_THROW(files_.Write("report_path", "", "the report"));
  EXPECT_NO_THROW(files_.Write("html_path", "", "the page"));
}

TEST_F(FileRolesTest, FilesThatCannotBeWrittenAreNamed) {
  EXPECT_THAT(
      [&] {
        files_.Write("output_path", folder_ / "gone" / "x", "the report");
      },
      ThrowsMessage<InputError>(HasSubstr("cannot be written")));
}

}  // namespace
}  // namespace octacut
