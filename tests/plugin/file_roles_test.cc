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
  OptionManager options_;
  FileRoles files_{options_};
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

TEST_F(FileRolesTest, TheProjectFileIsRead) {
  folder_.Write("run.ini", "");
  const std::vector<std::string> arguments = {"--project_path",
                                              folder_ / "run.ini"};
  options_.Parse(arguments);
  files_ = FileRoles(options_);
  ExpectRefused(folder_ / "run.ini", "the same file as the project file");
  EXPECT_NO_THROW(
      files_.Write("report_path", folder_ / "run.json", "the report"));
}

TEST_F(FileRolesTest, FilesOfTheWorkspaceAreKept) {
  Workspace workspace;
  workspace.image_path = folder_ / "images";
  workspace.mask_path = folder_ / "masks";
  workspace.model_path = folder_ / "sparse";
  for (const fs::path& path :
       {workspace.image_path, workspace.mask_path, workspace.model_path}) {
    fs::create_directories(path);
  }
  workspace.model.images.resize(1);
  workspace.model.images[0].name = "a.jpg";
  const auto expect_refused = [&](const fs::path& path,
                                  const std::string& what) {
    folder_.Write(path.lexically_relative(folder_ / "").string(), "precious");
    FileRoles files(options_);
    files.Write("report_path", path, "the report");
    EXPECT_THAT([&] { files.RequireApartFrom(workspace); },
                ThrowsMessage<OptionError>(
                    HasSubstr("report_path = " + path.string() +
                              ": must not be the same file as " + what)));
  };
  expect_refused(folder_ / "images/a.jpg", "a photograph of the workspace");
  expect_refused(folder_ / "masks/a.jpg.png", "a mask of the workspace");
  expect_refused(folder_ / "masks/masks.json", "the list of the masks");
  expect_refused(folder_ / "sparse/images.bin", "a file of the sparse model");
  folder_.Write("images/report.json", "of an earlier run");
  FileRoles files(options_);
  files.Write("report_path", folder_ / "images/report.json", "the report");
  EXPECT_NO_THROW(files.RequireApartFrom(workspace));
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
