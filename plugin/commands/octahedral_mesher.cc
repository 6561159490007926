#include "plugin/commands/octahedral_mesher.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/base/check_option.h"
#include "core/base/error.h"
#include "core/pipeline/reconstruct.h"
#include "plugin/mask_extraction.h"
#include "plugin/mesh_report.h"
#include "plugin/meshing_options.h"
#include "plugin/quality.h"
#include "plugin/reconstruction_json.h"
#include "plugin/run_picture.h"
#include "plugin/texturing.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

class OctahedralMesher : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  void CheckFiles(const OptionManager& options);
  LevelObserver LevelWriter() const;
  void MakeMasks(const Context& context);
  Json TextureMeshOf(const Scene& scene,
                     const IndexedMesh& mesh,
                     const Context& context,
                     AtomicFiles* files) const;

  WorkspaceArguments workspace_;
  QualityOption quality_;
  ReconstructionOptions meshing_;
  std::filesystem::path levels_path_;
  bool picture_ = true;
  bool texture_ = false;
  bool extract_masks_ = false;
  MaskExtractionOptions extraction_;
};

void OctahedralMesher::DeclareOptions(OptionManager& options) {
  workspace_.Declare("meshed-octahedral.ply", options);
  workspace_.DeclareConfidence(options);
  options
      .Add("save_levels",
           &levels_path_,
           "Folder in which the visual hull and the surface of each level "
           "are saved. Default: none.")
      .ForExperts();
  options
      .Add(
          "picture",
          &picture_,
          "If 1, save a picture of a photograph and the mesh next to the mesh.")
      .ForExperts();
  options.Add("texture",
              &texture_,
              "If 1, write a textured mesh (.glb) beside the mesh, or instead "
              "of it if output_path ends with .glb, as mesh_texturer does with "
              "its defaults.");
  options.Add("extract_masks",
              &extract_masks_,
              "If 1, make the masks first, as mask_extractor does with its "
              "defaults (OctahedralMeshing.bounding_box is used).");
  quality_.Declare(options);
  DeclareMeshingOptions(options, &meshing_);
}

void OctahedralMesher::MakeMasks(const Context& context) {
  WorkspaceOptions workspace = workspace_.loading.workspace;
  workspace.needs_masks = false;
  extraction_.output_path = workspace.mask_path.empty()
                                ? workspace_.workspace_path / "masks"
                                : workspace.mask_path;
  extraction_.skip_missing_images = workspace_.loading.skip_missing_images;
  extraction_.bounding_box = workspace_.bounding_box;
  ExtractMasks(OpenWorkspace(workspace_.workspace_path, workspace, context),
               extraction_,
               context);
}

// Views that were left out, because they contradict the others, do not texture
// the mesh either.
Json OctahedralMesher::TextureMeshOf(const Scene& scene,
                                     const IndexedMesh& mesh,
                                     const Context& context,
                                     AtomicFiles* files) const {
  PhotographOptions photographs;
  photographs.workspace = workspace_.loading.workspace;
  photographs.mask_geometry = workspace_.loading.mask_geometry;
  photographs.original_path = workspace_.loading.original_path;
  for (const View& view : scene.views) {
    photographs.names.push_back(view.name);
  }
  TexturingArguments arguments;
  arguments.output_path = workspace_.Beside(".glb");
  try {
    return TextureAndWrite({mesh, workspace_.output_path.string()},
                           workspace_.workspace_path,
                           photographs,
                           arguments,
                           context,
                           files);
  } catch (const OptionError& error) {
    throw InputError(fmt::format("{}: {} (options of mesh_texturer)",
                                 workspace_.output_path.string(),
                                 error.what()));
  }
}

// Of a mesh that save_levels writes; -1: the visual hull.
std::string NameOfLevel(int level) {
  return level < 0 ? "hull.ply" : fmt::format("level_{:02d}.ply", level);
}

LevelObserver OctahedralMesher::LevelWriter() const {
  if (levels_path_.empty()) {
    return nullptr;
  }
  std::error_code error;
  std::filesystem::create_directories(levels_path_, error);
  if (error) {
    throw InputError(
        fmt::format("save_levels {}: the folder cannot be created ({})",
                    levels_path_.string(),
                    error.message()));
  }
  CheckFilePath(levels_path_ / NameOfLevel(-1));
  return [folder = levels_path_](int level, const IndexedMesh& mesh) {
    WriteMesh(folder / NameOfLevel(level), mesh);
  };
}

void OctahedralMesher::CheckFiles(const OptionManager& options) {
  std::vector<WorkspaceArguments::FileBeside> beside;
  if (picture_) {
    beside.push_back({".png", "the picture"});
  }
  if (texture_) {
    beside.push_back({".glb", "the textured mesh"});
  }
  FileRoles files(options);
  if (!levels_path_.empty()) {
    files.Read(levels_path_, "the folder of save_levels");
    for (int level = -1; level <= meshing_.target_level; ++level) {
      files.Read(levels_path_ / NameOfLevel(level), "a mesh of save_levels");
    }
  }
  workspace_.Complete(beside, files);
}

void OctahedralMesher::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  context.Info(quality_.Apply(environment.options, &meshing_));
  meshing_.refinement.patch.chroma_weight = meshing_.consistency.chroma_weight;
  meshing_.confidence = workspace_.confidence;
  meshing_.Check();
  CheckFiles(environment.options);
  workspace_.loading.region.mask_tolerance = meshing_.masks.mask_tolerance;
  workspace_.loading.fill_bites = meshing_.masks.fill_false_gaps;
  const LevelObserver observer = LevelWriter();
  if (extract_masks_) {
    MakeMasks(context);
  }
  const LoadedScene loaded = LoadScene(workspace_.workspace_path,
                                       workspace_.loading,
                                       meshing_.target_level,
                                       context);
  context.Info(fmt::format(
      "The reconstruction needs about {:.1f} GB of memory in addition to the "
      "images.",
      1e-9 * double(EstimateReconstructionBytes(
                 loaded.scene, loaded.region.cube, meshing_, context))));
  const Reconstruction result =
      Reconstruct(loaded.scene, loaded.region, meshing_, context, observer);
  IndexedMesh mesh = ToIndexedMesh(result.mesh);
  mesh.confidence = result.verdict.confidence;
  AtomicFiles files;
  WriteMesh(workspace_.output_path, mesh, &files);
  if (picture_) {
    WriteRunPicture(
        workspace_.Beside(".png"), loaded.scene, mesh, context, &files);
  }
  Json members = {{"reconstruction", ReconstructionToJson(result.summary)}};
  if (texture_) {
    members["texture"] = TextureMeshOf(loaded.scene, mesh, context, &files);
  }
  WriteMeshReport(environment,
                  workspace_,
                  {loaded, result.audit, result.verdict, std::move(members)},
                  &files);
  PrintMesh(environment, workspace_, result.audit);
}

}  // namespace

std::unique_ptr<Command> MakeOctahedralMesher() {
  return std::make_unique<OctahedralMesher>();
}

}  // namespace octacut
