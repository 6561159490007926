#include "colmap_io/images/workspace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_io/images/mask_file.h"
#include "colmap_io/images/mask_geometry.h"
#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/write_sparse_model.h"
#include "tests/colmap_io/images/test_workspace.h"
#include "tests/colmap_io/model/text_model.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

using testing::Recorder;
using testing::RingModel;
using testing::WriteText;

const SparseCamera kWorkspacePinhole = {
    1, camera_model::kPinhole, 64, 48, {80, 80, 32, 24}};
const SparseCamera kWorkspaceRadial = {
    1, camera_model::kSimpleRadial, 640, 480, {500, 320, 240, -0.2}};

class WorkspaceTest : public testing::FolderTest {
 protected:
  void MakeFolders(const fs::path& workspace) {
    fs::create_directories(workspace / "images");
    fs::create_directories(workspace / "masks");
  }
  Workspace Open(const WorkspaceOptions& options = {}) {
    return OpenWorkspace(folder_, options, Context(1, &recorder_));
  }
  Recorder recorder_;
};

TEST_F(WorkspaceTest, DenseFolder) {
  MakeFolders(folder_);
  WriteSparseModelBinary(RingModel(kWorkspacePinhole, 4), folder_ / "sparse");
  const Workspace workspace = Open();
  EXPECT_TRUE(workspace.is_dense_folder);
  EXPECT_EQ(workspace.model_path, folder_ / "sparse");
  EXPECT_EQ(workspace.image_path, folder_ / "images");
  EXPECT_EQ(workspace.mask_path, folder_ / "masks");
  EXPECT_EQ(workspace.model.images.size(), 4u);
}

TEST_F(WorkspaceTest, DistortedModelRightInSparseIsNoDenseFolder) {
  MakeFolders(folder_);
  WriteTextModel(RingModel(kWorkspaceRadial, 4), folder_ / "sparse");
  EXPECT_FALSE(Open().is_dense_folder);
}

TEST_F(WorkspaceTest, MasksOfADenseFolderMayStandBesideIt) {
  const fs::path dense = folder_ / "dense" / "0";
  fs::create_directories(dense / "images");
  fs::create_directories(folder_ / "masks");
  WriteSparseModelBinary(RingModel(kWorkspacePinhole, 4), dense / "sparse");
  const Workspace workspace = OpenWorkspace(dense, {}, Context(1, &recorder_));
  EXPECT_TRUE(fs::equivalent(workspace.mask_path, folder_ / "masks"));
  fs::create_directories(folder_ / "dense" / "masks");
  EXPECT_TRUE(fs::equivalent(OpenWorkspace(dense, {}, Context(1)).mask_path,
                             folder_ / "dense" / "masks"));
}

TEST_F(WorkspaceTest, ProjectTakesTheModelWithMostImagesAndSaysSo) {
  MakeFolders(folder_);
  WriteSparseModelBinary(RingModel(kWorkspaceRadial, 4),
                         folder_ / "sparse" / "0");
  WriteTextModel(RingModel(kWorkspaceRadial, 9), folder_ / "sparse" / "2");
  WriteSparseModelBinary(RingModel(kWorkspaceRadial, 9),
                         folder_ / "sparse" / "10");
  const Workspace workspace = Open();
  EXPECT_FALSE(workspace.is_dense_folder);
  EXPECT_EQ(workspace.model_path, folder_ / "sparse" / "2");
  EXPECT_EQ(workspace.model.images.size(), 9u);
  ASSERT_EQ(recorder_.infos.size(), 1u);
  EXPECT_THAT(recorder_.infos[0], HasSubstr("sparse/2"));
  EXPECT_THAT(recorder_.infos[0], HasSubstr("(9)"));

  WorkspaceOptions options;
  options.input_path = folder_ / "sparse" / "0";
  EXPECT_EQ(Open(options).model.images.size(), 4u);
  options.input_path = folder_ / "sparse";
  EXPECT_EQ(Open(options).model.images.size(), 9u);
}

TEST_F(WorkspaceTest, LeavesADamagedModelOutAndSaysSo) {
  MakeFolders(folder_);
  WriteSparseModelBinary(RingModel(kWorkspaceRadial, 4),
                         folder_ / "sparse" / "1");
  WriteText(folder_ / "sparse" / "0" / "cameras.bin", "");
  EXPECT_EQ(Open().model_path, folder_ / "sparse" / "1");
  ASSERT_EQ(recorder_.warnings.size(), 1u);
  EXPECT_THAT(recorder_.warnings[0], HasSubstr("sparse/0"));
}

TEST_F(WorkspaceTest, NamesThePartThatIsMissing) {
  EXPECT_THAT(
      InputErrorOf([&] { OpenWorkspace(folder_ / "none", {}, Context(1)); }),
      HasSubstr("workspace_path"));
  EXPECT_THAT(InputErrorOf([&] { Open(); }), HasSubstr("--image_path"));
  fs::create_directories(folder_ / "images");
  EXPECT_THAT(InputErrorOf([&] { Open(); }), HasSubstr("--input_path"));
  fs::create_directories(folder_ / "sparse" / "0");
  EXPECT_THAT(InputErrorOf([&] { Open(); }),
              HasSubstr("nor its subfolders hold a sparse model"));
  WriteText(folder_ / "sparse" / "0" / "cameras.bin", "");
  EXPECT_THAT(InputErrorOf([&] { Open(); }), HasSubstr("sparse/0"));
  WriteSparseModelBinary(RingModel(kWorkspaceRadial, 4),
                         folder_ / "sparse" / "0");
  EXPECT_THAT(InputErrorOf([&] { Open(); }), HasSubstr("--mask_path"));
  WorkspaceOptions options;
  options.mask_path = folder_ / "elsewhere";
  EXPECT_THAT(InputErrorOf([&] { Open(options); }), HasSubstr("elsewhere"));
  fs::create_directories(folder_ / "elsewhere");
  EXPECT_EQ(Open(options).mask_path, folder_ / "elsewhere");
}

TEST_F(WorkspaceTest, FindsMasksInEveryNamingInOrder) {
  const fs::path masks = folder_ / "masks";
  const fs::path images = folder_ / "images";
  WriteText(images / "abc" / "012.jpg", "x");
  const auto find = [&] { return FindMaskFile(masks, "abc/012.jpg", images); };
  EXPECT_FALSE(find().has_value());
  // From the last choice to the first.
  for (const char* name : {"abc/012_mask.JPG",
                           "abc/012.jpeg",
                           "abc/012.jpg.jpg",
                           "abc/012.jpg",
                           "abc/012.PNG",
                           "abc/mask_012.png",
                           "abc/012_mask.png",
                           "abc/012.mask.png",
                           "abc/012.png",
                           "abc/012.jpg.png"}) {
    WriteText(masks / name, "x");
    ASSERT_TRUE(find().has_value()) << name;
    EXPECT_EQ(*find(), masks / name);
  }
  // A photograph is not its own mask.
  EXPECT_FALSE(FindMaskFile(images, "abc/012.jpg", images).has_value());
}

TEST_F(WorkspaceTest, MaskCamerasOfAProject) {
  MakeFolders(folder_);
  WriteSparseModelBinary(RingModel(kWorkspaceRadial, 4),
                         folder_ / "sparse" / "0");
  const Workspace workspace = Open();
  const SparseImage& image = workspace.model.images[0];
  const auto find = [&](MaskGeometry geometry, const ImageSize& size) {
    return MaskCameras(workspace, geometry, {})
        .Find(image, kWorkspaceRadial, size, "the mask");
  };
  const PinholeCamera undistorted = UndistortedCamera(kWorkspaceRadial);
  ASSERT_NE(undistorted.width, 640);
  const ImageSize undistorted_size{uint64_t(undistorted.width),
                                   uint64_t(undistorted.height)};
  EXPECT_EQ(find(MaskGeometry::kAuto, {640, 480}).params,
            kWorkspaceRadial.params);
  EXPECT_EQ(find(MaskGeometry::kOriginal, {640, 480}).params,
            kWorkspaceRadial.params);
  for (const auto geometry :
       {MaskGeometry::kAuto, MaskGeometry::kUndistorted}) {
    const SparseCamera camera = find(geometry, undistorted_size);
    EXPECT_EQ(camera.model_id, camera_model::kPinhole);
    EXPECT_EQ(camera.params[2], undistorted.cx);
  }
  // A dense folder beside knows better than the formula.
  SparseCamera given = {1, camera_model::kPinhole, 500, 400, {9, 9, 9, 9}};
  WriteSparseModelBinary(RingModel(given, 4),
                         folder_ / "dense" / "0" / "sparse");
  EXPECT_EQ(find(MaskGeometry::kAuto, {500, 400}).params, given.params);
  // Images of several dense folders have a camera in each.
  SparseCamera second = {1, camera_model::kPinhole, 501, 401, {8, 8, 8, 8}};
  WriteSparseModelBinary(RingModel(second, 4),
                         folder_ / "dense" / "1" / "sparse");
  EXPECT_EQ(find(MaskGeometry::kAuto, {500, 400}).params, given.params);
  EXPECT_EQ(find(MaskGeometry::kAuto, {501, 401}).params, second.params);
  EXPECT_THAT(InputErrorOf([&] {
                MaskCameras(workspace, MaskGeometry::kAuto, folder_ / "sparse");
              }),
              HasSubstr("is not a dense folder"));

  EXPECT_THAT(InputErrorOf([&] {
                find(MaskGeometry::kAuto, {333, 222});
              }),
              HasSubstr("the mask: the mask has 333x222 pixels"));
  EXPECT_THAT(InputErrorOf([&] {
                find(MaskGeometry::kUndistorted, {640, 480});
              }),
              HasSubstr("640x480"));
  EXPECT_THAT(InputErrorOf([&] {
                find(MaskGeometry::kOriginal, {500, 400});
              }),
              HasSubstr("--mask_geometry original"));
}

TEST_F(WorkspaceTest, MaskCamerasOfADenseFolder) {
  const fs::path dense = folder_ / "dense" / "0";
  MakeFolders(dense);
  WriteSparseModelBinary(RingModel(kWorkspacePinhole, 4), dense / "sparse");
  const Workspace workspace = OpenWorkspace(dense, {}, Context(1));
  const SparseImage& image = workspace.model.images[0];
  const auto find = [&](MaskGeometry geometry,
                        const ImageSize& size,
                        const fs::path& original = {}) {
    return MaskCameras(workspace, geometry, original)
        .Find(image, kWorkspacePinhole, size, "the mask");
  };
  EXPECT_EQ(find(MaskGeometry::kAuto, {64, 48}).params,
            kWorkspacePinhole.params);
  EXPECT_EQ(find(MaskGeometry::kUndistorted, {64, 48}).params,
            kWorkspacePinhole.params);
  EXPECT_THAT(InputErrorOf([&] {
                find(MaskGeometry::kAuto, {640, 480});
              }),
              HasSubstr("--original_path"));
  WriteSparseModelBinary(RingModel(kWorkspaceRadial, 4), folder_ / "elsewhere");
  EXPECT_EQ(find(MaskGeometry::kAuto, {640, 480}, folder_ / "elsewhere").params,
            kWorkspaceRadial.params);
  WriteSparseModelBinary(RingModel(kWorkspaceRadial, 4),
                         folder_ / "sparse" / "0");
  EXPECT_EQ(find(MaskGeometry::kAuto, {640, 480}).params,
            kWorkspaceRadial.params);
  EXPECT_EQ(find(MaskGeometry::kOriginal, {640, 480}).params,
            kWorkspaceRadial.params);
  EXPECT_THAT(InputErrorOf([&] {
                find(MaskGeometry::kOriginal, {64, 48});
              }),
              HasSubstr("64x48"));
  EXPECT_THAT(InputErrorOf([&] {
                find(MaskGeometry::kAuto, {640, 480}, folder_ / "mistyped");
              }),
              HasSubstr("mistyped: the folder holds no sparse model"));
}

// dense/1 is made of sparse/1, whatever lens sparse/0 has for its images.
TEST_F(WorkspaceTest, MaskCamerasOfTheModelOfTheSameNumber) {
  const fs::path dense = folder_ / "dense" / "1";
  MakeFolders(dense);
  WriteSparseModelBinary(RingModel(kWorkspacePinhole, 4), dense / "sparse");
  SparseCamera own = kWorkspaceRadial;
  own.params[3] += 0.01;
  WriteSparseModelBinary(RingModel(kWorkspaceRadial, 4),
                         folder_ / "sparse" / "0");
  WriteSparseModelBinary(RingModel(own, 4), folder_ / "sparse" / "1");
  const Workspace workspace = OpenWorkspace(dense, {}, Context(1));
  EXPECT_EQ(
      MaskCameras(workspace, MaskGeometry::kAuto, {})
          .Find(workspace.model.images[0], kWorkspacePinhole, {640, 480}, "")
          .params,
      own.params);
}

}  // namespace
}  // namespace octacut
