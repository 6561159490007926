#include "plugin/commands/mask_extractor.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "colmap_io/images/workspace.h"
#include "plugin/mask_extraction.h"

namespace octacut {
namespace {

class MaskExtractor : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  std::filesystem::path workspace_path_;
  WorkspaceOptions workspace_;
  MaskExtractionOptions extraction_;
};

void MaskExtractor::DeclareOptions(OptionManager& options) {
  options.AddRequired("workspace_path",
                      &workspace_path_,
                      "Folder of the COLMAP project (with images and sparse) "
                      "or a dense folder.");
  options.Add("image_path",
              &workspace_.image_path,
              "Folder of the photographs. Default: images in the workspace.");
  options.Add("input_path",
              &workspace_.input_path,
              "Folder of the sparse model. Default: the model in the workspace "
              "that has the most images.");
  options.Add("output_path",
              &extraction_.output_path,
              "Folder in which the masks, masks.json and contact_sheet.jpg are "
              "written. Masks in it that octacut did not make are used and "
              "kept. Default: masks in the workspace.");
  options.Add("image_list_path",
              &workspace_.image_list_path,
              "Text file with the names of the images to use, one per line. "
              "Default: all images of the model.");
  options.Add(
      "skip_missing_images",
      &extraction_.skip_missing_images,
      "If 1, leave out images whose file is missing instead of stopping.");
  DeclareMaskExtractionOptions(
      options, OptionAudience::kEveryone, &extraction_);
  options.Add("OctahedralMeshing.bounding_box",
              &extraction_.bounding_box,
              "Bounding box x0,y0,z0,x1,y1,z1 of the object in the frame of "
              "the sparse model. Default: where the cameras look.");
}

void MaskExtractor::Run(const CommandEnvironment& environment) {
  if (extraction_.output_path.empty()) {
    extraction_.output_path = workspace_path_ / "masks";
  }
  workspace_.needs_masks = false;
  const Workspace workspace =
      OpenWorkspace(workspace_path_, workspace_, environment.context);
  const MaskExtraction extraction =
      ExtractMasks(workspace, extraction_, environment.context);
  environment.out << fmt::format("{}: {} masks, {} given, {} views unsure\n",
                                 extraction_.output_path.string(),
                                 extraction.num_extracted,
                                 extraction.num_given,
                                 extraction.num_unsure);
}

}  // namespace

std::unique_ptr<Command> MakeMaskExtractor() {
  return std::make_unique<MaskExtractor>();
}

}  // namespace octacut
