#include "plugin/commands/mesh_refiner.h"

#include <fmt/format.h>

#include <algorithm>

#include "colmap_io/mesh/mesh_io.h"
#include "core/base/error.h"
#include "core/mesh/audit.h"
#include "core/pipeline/prepare_scene.h"
#include "core/scene/region.h"
#include "core/verdict/judge_mesh.h"
#include "plugin/closed_mesh.h"
#include "plugin/mesh_report.h"
#include "plugin/refinement_options.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

class MeshRefiner : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  WorkspaceArguments workspace_;
  std::filesystem::path mesh_path_;
  int target_level_ = 9;
  MaskOptions masks_;
  RefineOptions refinement_;
};

void MeshRefiner::DeclareOptions(OptionManager& options) {
  workspace_.Declare("meshed-refined.ply", options);
  workspace_.DeclareConfidence(options);
  options.Add("mesh_path",
              &mesh_path_,
              "Closed mesh to refine, in the frame of the sparse model. "
              "Default: meshed-octahedral.ply in the workspace.");
  options.Add("OctahedralMeshing.target_level",
              &target_level_,
              "The images are downsampled to 1.5 pixels per voxel of "
              "(2^level)^3. Use the level that the mesh was made with.");
  DeclareMaskTolerance(options, &masks_.mask_tolerance);
  DeclareFillFalseGaps(options, &masks_.fill_false_gaps);
  DeclareMoveMaskBorders(options, &masks_.move_mask_borders);
  DeclareChromaWeight(options, &refinement_.patch.chroma_weight);
  DeclareRefinementOptions(options, &refinement_);
}

void RequireSeen(const std::filesystem::path& path,
                 const RefineSummary& summary) {
  const bool is_seen =
      std::any_of(summary.rounds.begin(),
                  summary.rounds.end(),
                  [](const RoundSummary& round) { return round.num_seen > 0; });
  if (!is_seen) {
    throw InputError(
        fmt::format("{}: no two views show the mesh; is it in another frame "
                    "than the sparse model?",
                    path.string()));
  }
}

void MeshRefiner::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  masks_.Check();
  refinement_.Check();
  if (mesh_path_.empty()) {
    mesh_path_ = workspace_.workspace_path / "meshed-octahedral.ply";
  }
  FileRoles files(environment.options);
  files.Read(mesh_path_, "the mesh to refine");
  workspace_.Complete({}, files);
  IndexedMesh mesh = ReadClosedMesh(mesh_path_, context);
  // The windows of the images, which these decide, are to be the mesher's.
  workspace_.loading.region.mask_tolerance = masks_.mask_tolerance;
  workspace_.loading.fill_bites = masks_.fill_false_gaps;
  const LoadedScene loaded = LoadScene(
      workspace_.workspace_path, workspace_.loading, target_level_, context);
  CheckFloatsResolve(loaded.region.cube, target_level_);
  PreparedScene prepared =
      PrepareScene(loaded.scene, loaded.region.cube, masks_, context);
  ViewSet& views = prepared.views;
  RefinedSurface refined = RefineSurface(
      std::move(mesh), loaded.region.cube, refinement_, context, &views);
  RequireSeen(mesh_path_, refined.summary);
  const MeshAudit audit = AuditMesh(refined.mesh, context);
  CheckAudit(audit);
  const MeshVerdict verdict =
      JudgeMesh(refined.mesh,
                IndexedMesh(),
                {loaded.scene.views,
                 prepared.repaired.scene.views,
                 views,
                 loaded.region.cube},
                {.mask_tolerance = masks_.mask_tolerance,
                 .border_shift = refined.summary.border_shift,
                 .moved_inwards = prepared.moved_inwards,
                 .refinement = refinement_,
                 .confidence = workspace_.confidence},
                context);
  refined.mesh.confidence = verdict.confidence;
  AtomicFiles written;
  WriteMesh(workspace_.output_path, refined.mesh, &written);
  WriteMeshReport(environment,
                  workspace_,
                  {loaded,
                   audit,
                   verdict,
                   {{"refinement", RefinementToJson(refined.summary)}}},
                  &written);
  environment.out << fmt::format(
      "{}: {} of {} vertices moved by {:.2f} pixels on average; agreement of "
      "the views {:.3f} (before: {:.3f})\n",
      workspace_.output_path.string(),
      refined.summary.num_moved,
      refined.summary.num_vertices,
      refined.summary.mean_displacement,
      refined.summary.agreement_after,
      refined.summary.agreement_before);
}

}  // namespace

std::unique_ptr<Command> MakeMeshRefiner() {
  return std::make_unique<MeshRefiner>();
}

}  // namespace octacut
