#include "plugin/commands/mask_renderer.h"

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/core.hpp>
#include <vector>

#include "colmap_io/images/mask_folder.h"
#include "colmap_io/images/workspace.h"
#include "colmap_io/model/camera_projector.h"
#include "core/raycast/render_silhouette.h"
#include "plugin/read_mesh.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

class MaskRenderer : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  fs::path workspace_path_;
  WorkspaceOptions workspace_;
  fs::path mesh_path_;
  fs::path output_path_;
};

void MaskRenderer::DeclareOptions(OptionManager& options) {
  options.AddRequired("workspace_path",
                      &workspace_path_,
                      "Folder of the COLMAP project (with sparse) or a dense "
                      "folder.");
  options.Add("input_path",
              &workspace_.input_path,
              "Folder of the sparse model. Default: the model in the workspace "
              "that has the most images.");
  options.AddRequired("mesh_path",
                      &mesh_path_,
                      "Mesh (.ply, .obj, .off or .stl) in the frame of the "
                      "sparse model.");
  options.AddRequired("output_path",
                      &output_path_,
                      "Folder in which the masks are written. It may not hold "
                      "masks that octacut did not make.");
  options.Add("image_list_path",
              &workspace_.image_list_path,
              "Text file with the names of the images to use, one per line. "
              "Default: all images of the model.");
}

void MaskRenderer::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  workspace_.needs_images = false;
  workspace_.needs_masks = false;
  const Workspace workspace =
      OpenWorkspace(workspace_path_, workspace_, context);
  RequireOnlyOwnMasks(output_path_, workspace.image_path);
  const IndexedMesh mesh = ReadMeshAndLog(mesh_path_, context).mesh;
  const auto rays =
      NamingErrors(mesh_path_.string(), [&] { return RayScene(mesh); });
  MaskList list;
  std::vector<std::vector<uchar>> pngs;
  size_t num_empty = 0;
  Phase phase(context, "rendering masks", workspace.model.images.size());
  for (const SparseImage& image : workspace.model.images) {
    const SparseCamera& camera = *workspace.model.FindCamera(image.camera_id);
    const CameraProjector projector(camera);
    const cv::Mat mask = RenderSilhouette(
        rays,
        {int(camera.width), int(camera.height)},
        [&](const Eigen::Vector2d& pixel) {
          return projector.CamFromImg(pixel);
        },
        image.CamFromWorld(),
        context);
    num_empty += cv::countNonZero(mask) == 0 ? 1 : 0;
    pngs.push_back(EncodeMask(mask));
    ListedMask& listed = list.views.emplace_back();
    listed.image = image.name;
    listed.confidence = 1;
    phase.Advance();
  }
  if (num_empty == list.views.size()) {
    throw InputError(fmt::format(
        "mesh_path {}: no camera of {} sees the mesh; it must be in the frame "
        "of the sparse model",
        mesh_path_.string(),
        workspace.model_path.string()));
  }
  WriteMaskFolder(output_path_, list, pngs, cv::Mat());
  environment.out << fmt::format("{}: {} masks, {} of them empty\n",
                                 output_path_.string(),
                                 list.views.size(),
                                 num_empty);
}

}  // namespace

std::unique_ptr<Command> MakeMaskRenderer() {
  return std::make_unique<MaskRenderer>();
}

}  // namespace octacut
