#include "plugin/commands/mask_undistorter.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "colmap_io/images/for_each_file.h"
#include "colmap_io/images/image_file.h"
#include "colmap_io/images/mask_folder.h"
#include "colmap_io/images/most_pixels.h"
#include "colmap_io/images/undistort.h"
#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/images/view_files.h"
#include "colmap_io/images/workspace.h"
#include "colmap_io/model/read_sparse_model.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Mask, undistorted mask and file.
constexpr size_t kBytesPerPixel = 8;

class MaskUndistorter : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  std::map<std::string, PinholeCamera> TargetCameras(
      const std::vector<ViewFiles>& views) const;

  fs::path workspace_path_;
  WorkspaceOptions workspace_;
  fs::path undistorted_path_;
  fs::path output_path_;
  bool skip_missing_masks_ = false;
};

void MaskUndistorter::DeclareOptions(OptionManager& options) {
  options.AddRequired("workspace_path",
                      &workspace_path_,
                      "Folder of the COLMAP project (with masks and sparse).");
  options.Add("input_path",
              &workspace_.input_path,
              "Folder of the sparse model of the original photographs. "
              "Default: the model in the workspace that has the most images.");
  options.Add(
      "mask_path",
      &workspace_.mask_path,
      "Folder of the silhouette masks. Default: masks in the workspace.");
  options.Add("undistorted_path",
              &undistorted_path_,
              "Folder of the sparse model that image_undistorter has written, "
              "dense/sparse. Default: the cameras that image_undistorter makes "
              "with its default options.");
  options.AddRequired("output_path",
                      &output_path_,
                      "Folder in which the undistorted masks are written. It "
                      "may not hold masks that octacut did not make.");
  options.Add("skip_missing_masks",
              &skip_missing_masks_,
              "If 1, leave out images whose mask is missing instead of "
              "stopping.");
}

std::map<std::string, PinholeCamera> MaskUndistorter::TargetCameras(
    const std::vector<ViewFiles>& views) const {
  std::map<std::string, PinholeCamera> targets;
  if (undistorted_path_.empty()) {
    for (const ViewFiles& view : views) {
      targets[view.image->name] = UndistortedCamera(*view.camera);
    }
    return targets;
  }
  const SparseModel model = ReadSparseModel(undistorted_path_);
  for (const SparseImage& image : model.images) {
    const SparseCamera& camera = *model.FindCamera(image.camera_id);
    if (!IsPinhole(camera)) {
      throw InputError(fmt::format(
          "undistorted_path {}: camera {} of image {} has a distortion; this "
          "is not a model of undistorted images",
          undistorted_path_.string(),
          camera.id,
          image.name));
    }
    targets[image.name] = UndistortedCamera(camera);
  }
  for (const ViewFiles& view : views) {
    if (targets.count(view.image->name) == 0) {
      throw InputError(fmt::format("undistorted_path {}: there is no image {}",
                                   undistorted_path_.string(),
                                   view.image->name));
    }
  }
  return targets;
}

void MaskUndistorter::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  workspace_.needs_images = false;
  const Workspace workspace =
      OpenWorkspace(workspace_path_, workspace_, context);
  std::error_code ignored;
  if (fs::equivalent(workspace.mask_path, output_path_, ignored)) {
    throw InputError(
        fmt::format("output_path {}: this is the folder of the original masks",
                    output_path_.string()));
  }
  RequireOnlyOwnMasks(output_path_, workspace.image_path);
  const std::vector<ViewFiles> views =
      FindViewFiles(
          workspace,
          {.need_images = false, .skip_missing_masks = skip_missing_masks_},
          context)
          .views;
  const std::map<std::string, PinholeCamera> targets = TargetCameras(views);
  const std::optional<MaskList> before = ReadMaskList(workspace.mask_path);
  MaskList list;
  list.is_of_turntable = before && before->is_of_turntable;
  list.views.resize(views.size());
  std::vector<std::vector<uchar>> pngs(views.size());
  ForEachFile(
      {.count = views.size(),
       .bytes_per_file =
           kBytesPerPixel * MostPixels(views, &ViewFiles::camera)},
      "undistorting masks",
      context,
      [&](size_t i) {
        const ViewFiles& view = views[i];
        const cv::Mat mask = ReadMask(view.mask_file);
        RequireSizeOfCamera(view.mask_file, mask, *view.camera);
        pngs[i] = EncodeMask(Undistort(
            mask, *view.camera, targets.at(view.image->name), 0, Context(1)));
        ListedMask& listed = list.views[i];
        const ListedMask* const source =
            before ? before->Find(view.image->name) : nullptr;
        listed.image = view.image->name;
        listed.confidence = source == nullptr ? 1 : source->confidence;
      });
  // That these views have no mask is still known.
  for (const ListedMask& source :
       before ? before->views : std::vector<ListedMask>()) {
    if (source.status == MaskStatus::kUnsure &&
        list.Find(source.image) == nullptr) {
      list.views.push_back(source);
    }
  }
  WriteMaskFolder(output_path_, list, pngs, cv::Mat());
  environment.out << fmt::format(
      "{}: {} masks\n", output_path_.string(), views.size());
}

}  // namespace

std::unique_ptr<Command> MakeMaskUndistorter() {
  return std::make_unique<MaskUndistorter>();
}

}  // namespace octacut
