#include "plugin/commands/mask_extractor.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>

#include "colmap_io/images/workspace.h"
#include "core/base/check_option.h"
#include "plugin/mask_extraction.h"
#include "plugin/turntable_extraction.h"

namespace octacut {
namespace {

enum class MaskMode { kSparseModel, kTurntable };

class MaskExtractor : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  MaskList RunTurntable(const Context& context) const;
  void Report(const CommandEnvironment& environment,
              const MaskList& list) const;

  MaskMode mode_ = MaskMode::kSparseModel;
  std::filesystem::path workspace_path_;
  std::filesystem::path background_path_;
  WorkspaceOptions workspace_;
  MaskExtractionOptions extraction_;
};

void MaskExtractor::DeclareOptions(OptionManager& options) {
  options.Add("workspace_path",
              &workspace_path_,
              "Folder of the COLMAP project (with images and sparse) or a "
              "dense folder. Required unless mode is turntable.");
  options.AddEnum(
      "mode",
      &mode_,
      {{"sparse_model", MaskMode::kSparseModel},
       {"turntable", MaskMode::kTurntable}},
      "sparse_model: segment the object with the cameras of a sparse "
      "model. turntable: segment what moves in front of a fixed "
      "camera; needs image_path and output_path, but no sparse model.");
  options.Add("image_path",
              &workspace_.image_path,
              "Folder of the photographs. Default: images in the workspace.");
  options.Add("input_path",
              &workspace_.input_path,
              "Folder of the sparse model. Default: the model in the workspace "
              "that has the most images.");
  options.Add("output_path",
              &extraction_.output_path,
              "Folder for the masks, masks.json and contact_sheet.jpg. Masks "
              "in it that octacut has not written are used as input and kept. "
              "Default: masks in the workspace.");
  options.Add("image_list_path",
              &workspace_.image_list_path,
              "Text file with the names of the images to use, one per line. "
              "Default: all images of the model.");
  options.Add(
      "skip_missing_images",
      &extraction_.skip_missing_images,
      "If 1, leave out images whose file is missing instead of stopping.");
  options.Add("background_path",
              &background_path_,
              "Folder of photographs without the object, for mode turntable. "
              "Default: none.");
  DeclareMaskExtractionOptions(options, &extraction_);
  options.Add("OctahedralMeshing.bounding_box",
              &extraction_.bounding_box,
              "Bounding box x0,y0,z0,x1,y1,z1 of the object in the frame of "
              "the sparse model. Default: estimated from the poses.");
}

void MaskExtractor::Run(const CommandEnvironment& environment) {
  if (mode_ == MaskMode::kTurntable) {
    Report(environment, RunTurntable(environment.context));
    return;
  }
  if (workspace_path_.empty()) {
    throw OptionError(
        "option --workspace_path is required unless --mode turntable is given");
  }
  CheckOption(background_path_.empty(),
              "background_path",
              background_path_.string(),
              "is for mode turntable");
  if (extraction_.output_path.empty()) {
    extraction_.output_path = workspace_path_ / "masks";
  }
  workspace_.needs_masks = false;
  const Workspace workspace =
      OpenWorkspace(workspace_path_, workspace_, environment.context);
  Report(environment,
         ExtractMasks(workspace, extraction_, environment.context));
}

MaskList MaskExtractor::RunTurntable(const Context& context) const {
  for (const auto& [name, value] :
       {std::pair("image_path", workspace_.image_path),
        std::pair("output_path", extraction_.output_path)}) {
    CheckOption(
        !value.empty(), name, value.string(), "is required for mode turntable");
  }
  for (const auto& [name, is_set] :
       {std::pair("workspace_path", !workspace_path_.empty()),
        std::pair("input_path", !workspace_.input_path.empty()),
        std::pair("image_list_path", !workspace_.image_list_path.empty()),
        std::pair("skip_missing_images", extraction_.skip_missing_images),
        std::pair("given_masks_path", !extraction_.given_masks_path.empty()),
        std::pair("strokes_path", !extraction_.strokes_path.empty()),
        std::pair("network_path", !extraction_.network_path.empty()),
        std::pair("on_stand", extraction_.on_stand != -1),
        std::pair("OctahedralMeshing.bounding_box",
                  !extraction_.bounding_box.empty())}) {
    if (is_set) {
      throw OptionError(fmt::format(
          "--{} cannot be used with --mode turntable, which uses no cameras",
          name));
    }
  }
  return ExtractTurntableMasks({.image_path = workspace_.image_path,
                                .output_path = extraction_.output_path,
                                .background_path = background_path_},
                               context);
}

void MaskExtractor::Report(const CommandEnvironment& environment,
                           const MaskList& list) const {
  environment.out << fmt::format("{}: {} masks, {} given, {} views unsure\n",
                                 extraction_.output_path.string(),
                                 list.Count(MaskStatus::kExtracted),
                                 list.Count(MaskStatus::kGiven),
                                 list.Count(MaskStatus::kUnsure));
}

}  // namespace

std::unique_ptr<Command> MakeMaskExtractor() {
  return std::make_unique<MaskExtractor>();
}

}  // namespace octacut
