#include "plugin/commands/mesh_evaluator.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "core/base/check_option.h"
#include "core/benchmark/evaluate/evaluate_mesh.h"
#include "plugin/measured_mesh.h"
#include "plugin/mesh_json.h"
#include "plugin/report.h"
#include "plugin/text_table.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

class MeshEvaluator : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  std::filesystem::path workspace_path_;
  LoadSceneOptions loading_;
  std::vector<std::filesystem::path> mesh_paths_;
  std::filesystem::path output_path_;
  int image_level_ = 10;
  bool self_intersections_ = true;
  EvaluateMeshOptions evaluate_;
};

void MeshEvaluator::DeclareOptions(OptionManager& options) {
  DeclareLoadingOptions(options, &workspace_path_, &loading_);
  options.AddRequiredRepeatable("mesh_path",
                                &mesh_paths_,
                                "Mesh to evaluate (.ply, .obj, .off or .stl), "
                                "in the frame of the sparse model.");
  options.Add(
      "output_path", &output_path_, "JSON report to write. Default: none.");
  options
      .Add("image_level",
           &image_level_,
           "Downsample the images as for (2^level)^3 voxels, 1 to 20. All "
           "results in pixels refer to these images.")
      .ForExperts();
  options
      .Add("self_intersections",
           &self_intersections_,
           "If 1, count the triangles of each mesh that intersect others of "
           "the same mesh.")
      .ForExperts();
  options.Add("photometric",
              &evaluate_.photometric,
              "If 0, evaluate only silhouettes, which needs no photographs.");
  options.AddConstant("Reprojection.num_neighbors",
                      evaluate_.reprojection.num_neighbors);
  options.AddConstant("Reprojection.min_angle",
                      evaluate_.reprojection.min_angle);
  options.AddConstant("Reprojection.max_angle",
                      evaluate_.reprojection.max_angle);
  options.AddConstant("Reprojection.window_radius",
                      evaluate_.reprojection.window_radius);
  options.AddConstant("Reprojection.min_contrast",
                      evaluate_.reprojection.min_contrast);
}

std::vector<std::string> TableRow(const std::string& name,
                                  const MeshEvaluation& evaluation) {
  const auto percent = [](double fraction) {
    return fmt::format("{:.3f}", 100 * fraction);
  };
  const SilhouetteAgreement& silhouettes = evaluation.silhouettes;
  std::vector<std::string> row = {
      name,
      percent(silhouettes.intersection_over_union),
      percent(silhouettes.missed),
      percent(silhouettes.excess),
      fmt::format("{:.3f}", silhouettes.outline_mean),
      fmt::format("{:.3f}", silhouettes.outline_percentile_95)};
  if (const auto& reprojection = evaluation.reprojection) {
    row.insert(row.end(),
               {fmt::format("{:.4f}", reprojection->mean_correlation),
                fmt::format("{:.4f}", reprojection->percentile_10),
                percent(reprojection->compared_fraction)});
  }
  return row;
}

void MeshEvaluator::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  evaluate_.Check();
  CheckOption(image_level_ >= 1 && image_level_ <= 20,
              "image_level",
              image_level_,
              "must be in 1 .. 20");
  CheckReportPath(output_path_, mesh_paths_);
  loading_.load_images = evaluate_.photometric;
  // A mesh is judged by what it is given.
  loading_.keep_all_views = true;
  const LoadedScene loaded =
      LoadScene(workspace_path_, loading_, image_level_, context);
  std::vector<std::string> heading = {"mesh",
                                      "overlap, %",
                                      "missed, %",
                                      "excess, %",
                                      "outline: mean, pixels",
                                      "95 %"};
  if (evaluate_.photometric) {
    heading.insert(heading.end(), {"correlation: mean", "10 %", "compared, %"});
  }
  TextTable table(std::move(heading));
  Json meshes = Json::array();
  for (const std::filesystem::path& path : mesh_paths_) {
    MeasuredMesh measured = MeasureMesh(
        path, NameAmong(path, mesh_paths_), self_intersections_, context);
    const Phase phase(context,
                      fmt::format("Evaluate {}", measured.result.name));
    const MeshEvaluation evaluation =
        EvaluateMesh(measured.mesh, loaded.scene.views, evaluate_, context);
    measured.json.update(EvaluationToJson(evaluation, loaded.scene.views));
    meshes.push_back(std::move(measured.json));
    table.AddRow(TableRow(measured.result.name, evaluation));
  }
  environment.out << table.ToString();
  if (!output_path_.empty()) {
    Json report = MakeReport(environment);
    report["input"] = LoadSummaryToJson(loaded.summary, loaded.region);
    report["meshes"] = std::move(meshes);
    WriteReport(output_path_, report);
  }
}

}  // namespace

std::unique_ptr<Command> MakeMeshEvaluator() {
  return std::make_unique<MeshEvaluator>();
}

}  // namespace octacut
