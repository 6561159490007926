#include "colmap_io/images/load_scene.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <utility>
#include <vector>

#include "colmap_io/images/candidates.h"
#include "colmap_io/images/for_each_file.h"
#include "colmap_io/images/image_file.h"
#include "colmap_io/images/mask_view.h"
#include "colmap_io/images/most_pixels.h"
#include "colmap_io/images/scene_points.h"
#include "colmap_io/images/undistort.h"
#include "colmap_io/images/view_files.h"
#include "colmap_io/model/camera_projector.h"
#include "core/base/check_option.h"
#include "core/base/stopwatch.h"
#include "core/scene/contradictions.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Decoded bytes of one photograph in flight, a pixel: image, mask, file.
constexpr size_t kLoadedBytes = 6;

WorkspaceOptions WithImages(const LoadSceneOptions& options) {
  WorkspaceOptions workspace = options.workspace;
  workspace.needs_images = options.load_images;
  return workspace;
}

class Loader {
 public:
  Loader(const fs::path& workspace_path,
         const LoadSceneOptions& options,
         int target_level,
         const Context& context)
      : options_(options),
        target_level_(target_level),
        context_(context),
        workspace_(OpenWorkspace(workspace_path, WithImages(options), context)),
        mask_cameras_(
            workspace_, options.mask_geometry, options.original_path) {}

  LoadedScene Run() {
    LoadSceneSummary& summary = result_.summary;
    summary.image_path = workspace_.image_path;
    summary.model_path = workspace_.model_path;
    summary.mask_path = workspace_.mask_path;
    summary.num_images = workspace_.model.images.size();

    Stopwatch stopwatch;
    FindCandidates();
    ReadReducedMasks();
    summary.mask_seconds = stopwatch.Lap();

    if (!options_.keep_all_views) {
      LeaveOutBadViews();
      summary.bad_views.seconds = stopwatch.Lap();
    }

    // A given box may be that of one of several objects: a mask lacks the
    // others for good reason.
    if (options_.fill_bites && !options_.region.bounding_box) {
      summary.num_filled_bites =
          FillBites(options_.region.mask_tolerance, context_, &candidates_);
    }
    FindRegion();
    summary.region_seconds = stopwatch.Lap();

    PlanWindows();
    ReadViews();
    summary.image_seconds = stopwatch.Lap();
    return std::move(result_);
  }

 private:
  void FindCandidates();
  void ReadReducedMasks();
  void LeaveOutBadViews();
  void FindRegion();
  bool ShowsGivenRegion(const Candidate& candidate) const;
  void PlanWindows();
  void ReadViews();
  void ReadView(const Candidate& candidate, View* view) const;
  // Calls body(i) for all candidates, as many at a time as decode_budget
  // allows; the first candidate's error is thrown.
  void ForEachCandidate(std::string_view phase,
                        const std::function<void(size_t)>& body) const;
  const Frame& FrameOf(const SparseCamera& camera) const {
    return frames_.at(camera.id);
  }

  const LoadSceneOptions& options_;
  const int target_level_;
  const Context& context_;
  const Workspace workspace_;
  const MaskCameras mask_cameras_;
  std::map<uint32_t, Frame> frames_;  // by camera id
  std::vector<Candidate> candidates_;
  LoadedScene result_;
};

void Loader::FindCandidates() {
  ViewFilesOptions files_options;
  files_options.need_images = options_.load_images;
  files_options.skip_missing_images = options_.skip_missing_images;
  files_options.skip_missing_masks = options_.skip_missing_masks;
  FoundViewFiles found = FindViewFiles(workspace_, files_options, context_);
  result_.summary.num_missing_images = found.num_missing_images;
  result_.summary.num_missing_masks = found.num_missing_masks;
  for (const ViewFiles& files : found.views) {
    candidates_.emplace_back().files = files;
    if (!frames_.contains(files.camera->id)) {
      frames_.emplace(files.camera->id, FrameOfCamera(*files.camera));
    }
  }
}

void Loader::ForEachCandidate(std::string_view phase,
                              const std::function<void(size_t)>& body) const {
  const size_t pixels = MostPixels(candidates_, [](const Candidate& candidate) {
    return candidate.files.camera;
  });
  ForEachFile({.count = candidates_.size(),
               .bytes_per_file = kLoadedBytes * pixels,
               .byte_budget = options_.decode_budget},
              phase,
              context_,
              body);
}

void Loader::ReadReducedMasks() {
  ForEachCandidate("reading masks", [&](size_t i) {
    const ViewFiles& files = candidates_[i].files;
    candidates_[i].mask =
        ReadMaskView(files, FrameOf(*files.camera), mask_cameras_);
  });
  const size_t left_out = LeaveOutMasksWithoutOutline(
      options_.skip_missing_masks, context_, &candidates_);
  if (left_out > 0) {
    result_.summary.num_masks_without_outline = left_out;
    RequireEnoughViews(workspace_, candidates_.size());
  }
  WarnOfInvertedMasks(candidates_, context_);
}

// Before the region is found, which one such view distorts.
void Loader::LeaveOutBadViews() {
  std::vector<View> views;
  std::vector<JudgedView> judged;
  for (const Candidate& candidate : candidates_) {
    if (ShowsGivenRegion(candidate)) {
      views.push_back(candidate.mask.view);
      judged.push_back(
          {candidate.files.image->name, candidate.files.mask_file});
    }
  }
  BadViewSummary& bad_views = result_.summary.bad_views;
  bad_views =
      DecideOnBadViews(FindContradictions(views, context_), judged, context_);
  for (const BadView& bad : bad_views.views) {
    if (bad.is_left_out) {
      std::erase_if(candidates_, [&](const Candidate& candidate) {
        return candidate.files.image->name == bad.name;
      });
    }
  }
  RequireEnoughViews(workspace_, candidates_.size());
}

// A given box may be that of one of several objects, and other images may show
// other ones: those are no witnesses.
bool Loader::ShowsGivenRegion(const Candidate& candidate) const {
  if (!options_.region.bounding_box) {
    return true;
  }
  const Region region = EstimateRegion({}, {}, options_.region, context_);
  return PlanWindow(*candidate.files.camera,
                    FrameOf(*candidate.files.camera),
                    candidate.files.image->CamFromWorld(),
                    region,
                    target_level_,
                    options_.window)
      .has_value();
}

void Loader::FindRegion() {
  std::vector<View> views;
  for (Candidate& candidate : candidates_) {
    views.push_back(std::move(candidate.mask.view));
  }
  std::vector<Eigen::Vector3d>& points = result_.scene.points;
  points = ScenePoints(workspace_.model, views);
  result_.region = EstimateRegion(views, points, options_.region, context_);
  // A given box may be that of one of several objects.
  std::erase_if(points, [&](const Eigen::Vector3d& point) {
    return !result_.region.box.contains(point);
  });
  result_.summary.num_points = points.size();
}

void Loader::PlanWindows() {
  std::vector<Candidate> kept;
  std::vector<PinholeCamera> windows;
  for (const Candidate& candidate : candidates_) {
    const auto window = PlanWindow(*candidate.files.camera,
                                   FrameOf(*candidate.files.camera),
                                   candidate.files.image->CamFromWorld(),
                                   result_.region,
                                   target_level_,
                                   options_.window);
    if (window) {
      View& view = result_.scene.views.emplace_back();
      view.name = candidate.files.image->name;
      view.camera = *window;
      view.cam_from_world = candidate.files.image->CamFromWorld();
      view.scale =
          window->fx / CameraProjector(*candidate.files.camera).Intrinsics().fx;
      kept.push_back(candidate);
      windows.push_back(*window);
    }
  }
  LoadSceneSummary& summary = result_.summary;
  summary.num_views_elsewhere = candidates_.size() - kept.size();
  summary.num_views = kept.size();
  summary.scene_bytes = SceneBytes(windows);
  candidates_ = std::move(kept);
  if (summary.num_views_elsewhere > 0) {
    context_.Warn(
        fmt::format("{} of {} images do not show the bounding box of the "
                    "object and are left out.",
                    summary.num_views_elsewhere,
                    workspace_.model.images.size()));
  }
  RequireEnoughViews(workspace_, summary.num_views);
  context_.Info(fmt::format(
      "Using {} of the {} images of the sparse model {}. Reading them needs "
      "{:.0f} MB of memory.",
      summary.num_views,
      workspace_.model.images.size(),
      summary.model_path.string(),
      double(summary.scene_bytes) / 1e6));
}

void Loader::ReadView(const Candidate& candidate, View* view) const {
  // Views are loaded side by side; each by one thread.
  const Context alone(1);
  const cv::Mat mask = ReadMask(candidate.files.mask_file);
  const SparseCamera& mask_camera = candidate.mask.camera;
  view->mask = Undistort(mask, mask_camera, view->camera, 255, alone);
  view->unknown =
      FindUncovered(mask, mask_camera, view->camera, view->mask, alone);
  candidate.bites.Fill(view->camera, &view->mask);
  if (!options_.load_images) {
    return;
  }
  const fs::path path = workspace_.image_path / candidate.files.image->name;
  const cv::Mat photograph = ReadPhotograph(path);
  const SparseCamera& camera = *candidate.files.camera;
  RequireSizeOfCamera(path, photograph, camera);
  view->image = Undistort(photograph, camera, view->camera, 0, alone);
}

void Loader::ReadViews() {
  ForEachCandidate("reading images", [&](size_t i) {
    ReadView(candidates_[i], &result_.scene.views[i]);
  });
  WarnOfMasksElsewhere(candidates_, result_.scene.views, context_);
}

}  // namespace

void LoadSceneOptions::Check() const {
  region.Check();
  window.Check();
  CheckOption(decode_budget > 0,
              "decode_budget",
              decode_budget,
              "must be greater than 0");
}

LoadedScene LoadScene(const fs::path& workspace_path,
                      const LoadSceneOptions& options,
                      int target_level,
                      const Context& context) {
  options.Check();
  CheckOption(target_level >= 1 && target_level <= 20,
              "target_level",
              target_level,
              "must be in [1, 20]");
  return Loader(workspace_path, options, target_level, context).Run();
}

}  // namespace octacut
