#include "plugin/commands/visual_hull_mesher.h"

#include <fmt/format.h>

#include "colmap_io/mesh/mesh_io.h"
#include "core/pipeline/reconstruct_hull.h"
#include "plugin/mesh_report.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

class VisualHullMesher : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  WorkspaceArguments workspace_;
  HullReconstructionOptions options_;
};

void VisualHullMesher::DeclareOptions(OptionManager& options) {
  workspace_.Declare("meshed-visual-hull.ply", options);
  options.Add("OctahedralMeshing.hull_level",
              &options_.hull.hull_level,
              "Level of the visual hull, which has (2^level)^3 voxels.");
  DeclareFillFalseGaps(options, &options_.fill_false_gaps);
  options.AddConstant("Smoothing.iterations",
                      options_.finish.smoothing.iterations);
}

void VisualHullMesher::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  options_.Check();
  workspace_.Complete({}, FileRoles(environment.options));
  workspace_.loading.load_images = false;
  workspace_.loading.fill_bites = options_.fill_false_gaps;
  const LoadedScene loaded = LoadScene(workspace_.workspace_path,
                                       workspace_.loading,
                                       options_.hull.hull_level,
                                       context);
  const HullReconstruction result =
      ReconstructHull(loaded.scene, loaded.region, options_, context);
  AtomicFiles files;
  WriteMesh(workspace_.output_path, ToIndexedMesh(result.mesh), &files);
  WriteMeshReport(
      environment, workspace_, {loaded, result.audit, result.verdict}, &files);
  PrintMesh(environment, workspace_, result.audit);
}

}  // namespace

std::unique_ptr<Command> MakeVisualHullMesher() {
  return std::make_unique<VisualHullMesher>();
}

}  // namespace octacut
