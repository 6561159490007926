#include "plugin/mask_extraction.h"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <system_error>

#include "colmap_io/files/read_file.h"
#include "colmap_io/images/for_each_file.h"
#include "colmap_io/images/image_file.h"
#include "colmap_io/images/mask_folder.h"
#include "colmap_io/images/reduced_view.h"
#include "colmap_io/images/saliency_network.h"
#include "colmap_io/images/segmentation_files.h"
#include "colmap_io/model/camera_projector.h"
#include "core/base/check_option.h"
#include "core/base/error.h"
#include "core/scene/region.h"
#include "core/segment/labels.h"
#include "core/segment/other_views.h"
#include "core/segment/refine_border.h"
#include "core/segment/stand_pixels.h"
#include "core/segment/view_confidence.h"
#include "plugin/contact_sheet.h"
#include "plugin/find_stand.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Pixels of the segmented views by which their borders may be off.
constexpr double kReach = 2;
// Saliency from which on a network's word is taken for object, and up to which
// for surroundings; nothing is said between.
constexpr double kSalient = 0.8;
constexpr double kNotSalient = 0.2;

class Extractor {
 public:
  Extractor(const Workspace& workspace,
            const MaskExtractionOptions& options,
            const Context& context)
      : options_(options), context_(context) {
    CheckOption(options.on_stand >= -1 && options.on_stand <= 1,
                "on_stand",
                options.on_stand,
                "must be -1, 0 or 1");
    SegmentationFilesOptions files_options;
    files_options.given_masks_path = options.given_masks_path;
    files_options.strokes_path = options.strokes_path;
    files_options.output_path = options.output_path;
    files_options.skip_missing_images = options.skip_missing_images;
    files_ = ReadSegmentationFiles(workspace, files_options, context);
    files_.input.box = OptionalBoundingBox(options.bounding_box);
    if (options.on_stand != 0) {
      FindStand(workspace.model, options.on_stand == 1, context, &files_);
    }
    if (!options.network_path.empty()) {
      Propose();
    }
    encoded_.resize(files_.files.size());
    reduced_.resize(files_.files.size());
  }

  MaskList Run() {
    segmentation_ = SegmentObject(files_.input, context_);
    RefineAll();
    Judge();
    Write();
    return std::move(list_);
  }

 private:
  void Propose();
  void RefineAll();
  cv::Mat FullLabels(size_t view) const;
  cv::Mat RefinedMask(size_t view) const;
  void Judge();
  void Write();
  bool IsInPlace(size_t view) const {
    std::error_code ignored;
    return fs::equivalent(
        files_.files[view].given_mask.parent_path(),
        fs::path(options_.output_path / files_.files[view].image->name)
            .parent_path(),
        ignored);
  }

  const MaskExtractionOptions& options_;
  const Context& context_;
  SegmentationFiles files_;
  Segmentation segmentation_;
  std::vector<std::vector<uchar>> encoded_;  // PNG files
  std::vector<cv::Mat> reduced_;  // final masks at the size of the views
  std::vector<ViewConfidence> confidences_;
  MaskList list_;
};

// What the user's network takes for the object in each view.
void Extractor::Propose() {
  SaliencyNetwork network(options_.network_path);
  Phase phase(context_, "proposals of the network", files_.input.views.size());
  size_t num_views = 0;
  for (UnsegmentedView& view : files_.input.views) {
    const cv::Mat saliency = network.Saliency(view.image);
    view.proposal = cv::Mat(saliency.size(), CV_8U, cv::Scalar(kNoLabel));
    view.proposal.setTo(kObjectLabel, saliency >= kSalient);
    view.proposal.setTo(kSurroundingsLabel, saliency <= kNotSalient);
    num_views += cv::countNonZero(view.proposal == kObjectLabel) > 0;
    phase.Advance();
  }
  if (num_views == 0) {
    throw InputError(fmt::format(
        "network_path {}: the network finds no object in any photograph",
        options_.network_path.string()));
  }
  context_.Info(
      fmt::format("The network proposes an object in {} of {} photographs ({} "
                  "x {} pixels).",
                  num_views,
                  files_.input.views.size(),
                  network.InputSize().width,
                  network.InputSize().height));
}

// What is known for sure in the photograph; strokes take precedence.
cv::Mat Extractor::FullLabels(size_t view) const {
  const UnsegmentedView& input = files_.input.views[view];
  const SegmentationFile& file = files_.files[view];
  cv::Mat surroundings = ExcludedByOthers(segmentation_.views[view].others);
  if (!input.stand.empty()) {
    // Windows reach across the border of the object.
    cv::Mat stand;
    cv::erode(input.stand >= 1,
              stand,
              cv::Mat::ones(kStandWindow, kStandWindow, CV_8U));
    surroundings |= stand;
  }
  if (input.is_turntable) {
    surroundings |= input.labels == kSurroundingsLabel;
  }
  surroundings.convertTo(surroundings, CV_32F);
  const cv::Mat full = CarryBack(surroundings, input.pose.camera, *file.camera);
  cv::Mat labels(full.size(), CV_8U, cv::Scalar(kNoLabel));
  labels.setTo(kSurroundingsLabel, full >= kObjectThreshold);
  if (!file.strokes.empty() && !file.strokes_are_turntable_mask) {
    const cv::Mat strokes = ReadStrokes(file);
    strokes.copyTo(labels, strokes != kNoLabel);
  }
  return labels;
}

cv::Mat Extractor::RefinedMask(size_t view) const {
  const SegmentationFile& file = files_.files[view];
  const PinholeCamera& camera = files_.input.views[view].pose.camera;
  cv::Mat mask;
  segmentation_.views[view].mask.convertTo(mask, CV_32F);
  const cv::Mat full =
      CarryBack(mask, camera, *file.camera) >= kObjectThreshold;
  // At the centre: a reduced view of a wide lens has another projection.
  const double scale =
      CameraProjector(*file.camera).Intrinsics().fx / camera.fx;
  return RefineBorder(ReadPhotograph(file.photograph),
                      full,
                      kReach * std::max(1.0, scale),
                      FullLabels(view));
}

void Extractor::RefineAll() {
  ForEachFile(
      {.count = files_.files.size(),
       .bytes_per_file =
           BytesOfLargest(files_.files, kRefineBorderBytesPerPixel),
       .byte_budget = kRefineBorderBudget},
      "refining borders",
      context_,
      [&](size_t i) {
        const SegmentationFile& file = files_.files[i];
        const cv::Mat mask = file.given_mask.empty()
                                 ? RefinedMask(i)
                                 : ReadMask(file.given_mask);
        if (file.given_mask.empty() || !IsInPlace(i)) {
          encoded_[i] = EncodeMask(mask);
        }
        reduced_[i] =
            ReduceView(mask, *file.camera, files_.input.views[i].pose.camera) >=
            kObjectThreshold;
      });
}

void Extractor::Judge() {
  confidences_ = JudgeViews(segmentation_, reduced_);
  for (size_t i = 0; i < files_.files.size(); ++i) {
    const SegmentationFile& file = files_.files[i];
    ListedMask& listed = list_.views.emplace_back();
    listed.image = file.image->name;
    listed.confidence = confidences_[i].confidence;
    if (!file.given_mask.empty()) {
      listed.status = MaskStatus::kGiven;
      listed.confidence = 1;
    } else if (!confidences_[i].doubt.empty()) {
      listed.status = MaskStatus::kUnsure;
      listed.doubt = confidences_[i].doubt;
      continue;
    }
    if (!file.given_mask.empty() && IsInPlace(i)) {
      listed.mask =
          fs::path(file.given_mask).lexically_relative(options_.output_path);
      listed.hash = HashOfBytes(ReadFile(file.given_mask));
    }
  }
}

void Extractor::Write() {
  for (size_t i = 0; i < files_.files.size(); ++i) {
    if (list_.views[i].status == MaskStatus::kUnsure) {
      encoded_[i].clear();
    }
  }
  WriteMaskFolder(options_.output_path,
                  list_,
                  encoded_,
                  DrawContactSheet(files_.input.views, reduced_, list_));
}

}  // namespace

void DeclareMaskExtractionOptions(OptionManager& options,
                                  MaskExtractionOptions* extraction) {
  options.Add("given_masks_path",
              &extraction->given_masks_path,
              "Folder of masks that you have made for some of the images; they "
              "are used and kept. Default: none.");
  options.Add("strokes_path",
              &extraction->strokes_path,
              "Folder of strokes for some images, named like masks: 0 is "
              "background, 255 object, 128 unlabelled. Default: none.");
  options.Add(
      "network_path",
      &extraction->network_path,
      "ONNX file of a segmentation network, such as U2-Net, that is used as a "
      "prior (docs/masks.md). Default: none.");
  options.Add("on_stand",
              &extraction->on_stand,
              "Whether the plane on which the object stands (estimated from "
              "the sparse points) and everything below it are background in "
              "the masks: 1 always, 0 never, -1 if the photographs show an "
              "object that stands on a plane.");
}

MaskList ExtractMasks(const Workspace& workspace,
                      const MaskExtractionOptions& options,
                      const Context& context) {
  RequireFolderForMasks(options.output_path, workspace.image_path);
  return Extractor(workspace, options, context).Run();
}

}  // namespace octacut
