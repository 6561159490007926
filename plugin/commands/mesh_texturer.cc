#include "plugin/commands/mesh_texturer.h"

#include <fmt/format.h>

#include <filesystem>

#include "plugin/file_roles.h"
#include "plugin/read_mesh.h"
#include "plugin/report.h"
#include "plugin/texturing.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

class MeshTexturer : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  void Complete(const OptionManager& options);

  fs::path workspace_path_;
  LoadSceneOptions loading_;
  fs::path mesh_path_;
  fs::path report_path_;
  TexturingArguments arguments_;
};

void MeshTexturer::DeclareOptions(OptionManager& options) {
  DeclareImageOptions(options, &workspace_path_, &loading_);
  options.Add("mesh_path",
              &mesh_path_,
              "Mesh to texture, open or closed, in the frame of the sparse "
              "model. Default: meshed-octahedral.ply in the workspace.");
  options.Add("output_path",
              &arguments_.output_path,
              "Textured mesh to write (.glb, .obj or .ply). Default: the path "
              "of the mesh with the extension .glb.");
  options
      .Add("report_path", &report_path_, "JSON report to write. Default: none.")
      .ForExperts();
  arguments_.Declare(options);
}

void MeshTexturer::Complete(const OptionManager& options) {
  if (mesh_path_.empty()) {
    mesh_path_ = workspace_path_ / "meshed-octahedral.ply";
  }
  if (arguments_.output_path.empty()) {
    arguments_.output_path = mesh_path_;
    arguments_.output_path.replace_extension(".glb");
  }
  FileRoles files(options);
  files.Read(mesh_path_, "the mesh to texture");
  arguments_.Check(&files);
  files.Write("report_path", report_path_, "the report");
  files.Guard(&loading_.workspace);
}

void MeshTexturer::Run(const CommandEnvironment& environment) {
  Complete(environment.options);
  const IndexedMesh mesh = ReadMeshAndLog(mesh_path_, environment.context).mesh;
  PhotographOptions photographs;
  photographs.workspace = loading_.workspace;
  photographs.mask_geometry = loading_.mask_geometry;
  photographs.original_path = loading_.original_path;
  photographs.skip_missing_images = loading_.skip_missing_images;
  AtomicFiles files;
  const Json texture = TextureAndWrite({mesh, mesh_path_.string()},
                                       workspace_path_,
                                       photographs,
                                       arguments_,
                                       environment.context,
                                       &files);
  if (!report_path_.empty()) {
    Json report = MakeReport(environment);
    report["mesh_path"] = mesh_path_.string();
    report["texture"] = texture;
    WriteReport(report_path_, report, &files);
  }
  files.Commit();
  environment.out << fmt::format(
      "{}: {} triangles, {} charts on {} page(s), {:.2f} % of the surface not "
      "seen; mean jump across seams {:.2f} grey levels (before: {:.2f})\n",
      arguments_.output_path.string(),
      texture["triangles"].get<size_t>(),
      texture["charts"].get<size_t>(),
      texture["pages"].get<size_t>(),
      100 * texture["unseen_area_fraction"].get<double>(),
      texture["seams"]["mean_jump_after"].get<double>(),
      texture["seams"]["mean_jump_before"].get<double>());
}

}  // namespace

std::unique_ptr<Command> MakeMeshTexturer() {
  return std::make_unique<MeshTexturer>();
}

}  // namespace octacut
