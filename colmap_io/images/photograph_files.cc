#include "colmap_io/images/photograph_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <optional>
#include <set>
#include <system_error>

#include "colmap_io/images/image_file.h"
#include "colmap_io/images/mask_file.h"
#include "colmap_io/images/missing_files.h"
#include "colmap_io/images/most_pixels.h"
#include "colmap_io/images/undistort.h"
#include "colmap_io/images/view_files.h"
#include "colmap_io/images/view_window.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Bytes per pixel while a photograph is worked on: the file's pixels, those of
// the view, its mask, and two maps of floats.
constexpr size_t kWorkedOnBytes = 16;
// So fine a level that no photograph is reduced.
constexpr int kFullResolution = 20;

struct PhotographFile {
  const SparseImage* image = nullptr;
  const SparseCamera* camera = nullptr;
  std::optional<fs::path> mask_file;
  PinholeCamera window;
};

// Reads photographs, and keeps the first ones that fit into the budget.
class Reader {
 public:
  Reader(Workspace workspace, const PhotographOptions& options)
      : workspace_(std::move(workspace)),
        mask_cameras_(workspace_, options.mask_geometry, options.original_path),
        budget_(options.cache_budget) {}

  const Workspace& Parts() const { return workspace_; }
  std::vector<PhotographFile>& Files() { return files_; }

  Photograph Load(size_t i) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto kept = kept_.find(i); kept != kept_.end()) {
        return kept->second;
      }
    }
    Photograph photograph = Read(files_[i]);
    const size_t bytes = 4 * photograph.image.total();
    const std::lock_guard lock(mutex_);
    if (bytes <= budget_ && kept_.emplace(i, photograph).second) {
      budget_ -= bytes;
    }
    return photograph;
  }

 private:
  Photograph Read(const PhotographFile& file) const {
    const Context alone(1);
    const fs::path path = workspace_.image_path / file.image->name;
    const cv::Mat pixels = ReadPhotograph(path);
    RequireSizeOfCamera(path, pixels, *file.camera);
    Photograph photograph;
    photograph.image = Undistort(pixels, *file.camera, file.window, 0, alone);
    // Where the photograph does not reach, there is nothing to see.
    const cv::Mat all(pixels.size(), CV_8UC1, cv::Scalar(255));
    photograph.mask = Undistort(all, *file.camera, file.window, 0, alone);
    if (file.mask_file) {
      const cv::Mat mask = ReadMask(*file.mask_file);
      const SparseCamera camera =
          mask_cameras_.Find(*file.image,
                             *file.camera,
                             {uint64_t(mask.cols), uint64_t(mask.rows)},
                             file.mask_file->string());
      photograph.mask = cv::min(photograph.mask,
                                Undistort(mask, camera, file.window, 0, alone));
    }
    return photograph;
  }

  const Workspace workspace_;
  const MaskCameras mask_cameras_;
  std::vector<PhotographFile> files_;
  std::mutex mutex_;
  size_t budget_;
  std::map<size_t, Photograph> kept_;
};

// The images that are there and wanted, with their masks.
void FindFiles(const PhotographOptions& options,
               const Context& context,
               Reader* reader,
               PhotographSummary* summary) {
  const Workspace& workspace = reader->Parts();
  const std::set<std::string> names(options.names.begin(), options.names.end());
  MissingFiles missing{.what = "image"};
  for (const SparseImage& image : workspace.model.images) {
    if (!names.empty() && !names.contains(image.name)) {
      continue;
    }
    ++summary->num_images;
    const fs::path path = workspace.image_path / image.name;
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
      missing.Add(path);
      continue;
    }
    PhotographFile file;
    file.image = &image;
    file.camera = workspace.model.FindCamera(image.camera_id);
    if (!workspace.mask_path.empty()) {
      file.mask_file =
          FindMaskFile(workspace.mask_path, image.name, workspace.image_path);
    }
    summary->num_without_mask += file.mask_file ? 0 : 1;
    reader->Files().push_back(file);
  }
  summary->num_missing = missing.count;
  missing.Report(options.skip_missing_images, summary->num_images, context);
  if (reader->Files().empty()) {
    throw InputError(fmt::format("{}: none of {} images is in {}",
                                 workspace.model_path.string(),
                                 summary->num_images,
                                 workspace.image_path.string()));
  }
}

// Leaves out the photographs that do not show the box.
void PlanWindows(const Eigen::AlignedBox3d& box,
                 std::vector<PhotographFile>* files,
                 PhotographSummary* summary) {
  Region region;
  region.box = box;
  region.cube.min_corner = box.min();
  region.cube.edge = box.sizes().maxCoeff();
  std::map<uint32_t, Frame> frames;
  std::vector<PhotographFile> kept;
  for (PhotographFile& file : *files) {
    if (!frames.contains(file.camera->id)) {
      frames.emplace(file.camera->id, FrameOfCamera(*file.camera));
    }
    const auto window = PlanWindow(*file.camera,
                                   frames.at(file.camera->id),
                                   file.image->CamFromWorld(),
                                   region,
                                   kFullResolution,
                                   WindowOptions());
    if (window) {
      file.window = *window;
      kept.push_back(file);
    }
  }
  summary->num_elsewhere = files->size() - kept.size();
  *files = std::move(kept);
}

}  // namespace

PhotographFiles OpenPhotographs(const fs::path& workspace_path,
                                const PhotographOptions& options,
                                const Context& context) {
  WorkspaceOptions parts = options.workspace;
  parts.may_lack_masks = true;
  const auto reader = std::make_shared<Reader>(
      OpenWorkspace(workspace_path, parts, context), options);
  PhotographFiles result;
  PhotographSummary& summary = result.summary;
  summary.image_path = reader->Parts().image_path;
  summary.model_path = reader->Parts().model_path;
  summary.mask_path = reader->Parts().mask_path;
  FindFiles(options, context, reader.get(), &summary);
  PlanWindows(options.box, &reader->Files(), &summary);
  if (reader->Files().empty()) {
    throw InputError(fmt::format(
        "{}: none of the {} photographs shows the bounding box of the mesh; is "
        "the mesh in the frame of the sparse model?",
        summary.model_path.string(),
        summary.num_images - summary.num_missing));
  }
  if (!summary.mask_path.empty() && summary.num_without_mask > 0) {
    context.Warn(
        fmt::format("{}: {} of {} photographs have no mask and are "
                    "used as a whole",
                    summary.mask_path.string(),
                    summary.num_without_mask,
                    summary.num_images - summary.num_missing));
  }
  size_t pixels = MostPixels(reader->Files(), &PhotographFile::camera);
  for (const PhotographFile& file : reader->Files()) {
    // The view of a wide lens may be larger than its photograph.
    pixels = std::max(pixels,
                      size_t(file.window.width) * size_t(file.window.height));
    result.photographs.poses.push_back(
        {file.image->name, file.window, file.image->CamFromWorld()});
  }
  result.photographs.max_held =
      std::max<size_t>(1, options.decode_budget / (kWorkedOnBytes * pixels));
  result.photographs.load = [reader](size_t i) { return reader->Load(i); };
  return result;
}

}  // namespace octacut
