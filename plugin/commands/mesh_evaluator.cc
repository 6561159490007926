#include "plugin/commands/mesh_evaluator.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "core/base/check_option.h"
#include "core/benchmark/compare/compare_meshes.h"
#include "core/benchmark/compare/signed_distance.h"
#include "core/benchmark/evaluate/evaluate_mesh.h"
#include "core/raycast/ray_scene.h"
#include "plugin/file_roles.h"
#include "plugin/measured_mesh.h"
#include "plugin/mesh_json.h"
#include "plugin/page/page_builder.h"
#include "plugin/report.h"
#include "plugin/support_ranking.h"
#include "plugin/text_table.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

void CheckIsSeen(const std::filesystem::path& path,
                 const SilhouetteAgreement& silhouettes) {
  for (const ViewSilhouette& view : silhouettes.views) {
    if (view.mesh_pixels > 0) {
      return;
    }
  }
  throw InputError(
      fmt::format("{}: no view shows the mesh; is it in another frame than the "
                  "sparse model?",
                  path.string()));
}

struct JudgedMesh {
  MeasuredMesh measured;
  MeshEvaluation evaluation;
};

// clang-tidy does not see that moving a Json cannot fail.
// NOLINTNEXTLINE(bugprone-exception-escape)
class MeshEvaluator : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  bool UsesRandomSeed() const override { return true; }
  void Run(const CommandEnvironment& environment) override;

 private:
  TextTable MakeTable() const;
  std::vector<JudgedMesh> Judge(const std::vector<View>& views,
                                const Context& context,
                                TextTable* table);
  void AddToPage(const std::vector<JudgedMesh>& meshes,
                 size_t index,
                 const std::vector<View>& views,
                 const Context& context);
  void WritePage(const CommandEnvironment& environment,
                 const std::vector<View>& views,
                 const Json& report,
                 AtomicFiles* files);
  // The page and the report, as far as they are asked for.
  void WriteFiles(const CommandEnvironment& environment,
                  const std::vector<View>& views,
                  const Json& report);

  std::filesystem::path workspace_path_;
  LoadSceneOptions loading_;
  std::vector<std::filesystem::path> mesh_paths_;
  std::filesystem::path output_path_;
  std::filesystem::path html_path_;
  std::vector<double> bounding_box_;
  int image_level_ = 10;
  bool self_intersections_ = true;
  EvaluateMeshOptions evaluate_;
  ComparisonPage page_;
};

void MeshEvaluator::DeclareOptions(OptionManager& options) {
  DeclareLoadingOptions(options, &workspace_path_, &loading_);
  options.AddRequiredRepeatable("mesh_path",
                                &mesh_paths_,
                                "Mesh to evaluate (.ply, .obj, .off or .stl), "
                                "in the frame of the sparse model, or several "
                                "separated by commas.");
  options.Add(
      "output_path", &output_path_, "JSON report to write. Default: none.");
  options.Add("html_path",
              &html_path_,
              "HTML page to write: a viewer for the meshes and the "
              "photographs. Default: none.");
  DeclareBoundingBox(options, &bounding_box_);
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
                      ReprojectionOptions::kWindowRadius);
  options.AddConstant("Reprojection.min_contrast",
                      ReprojectionOptions::kMinContrast);
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
                percent(reprojection->compared_fraction),
                fmt::format("{:.4f}", MeanSupport(evaluation.view_support))});
  }
  return row;
}

TextTable MeshEvaluator::MakeTable() const {
  std::vector<std::string> heading = {"mesh",
                                      "overlap, %",
                                      "missed, %",
                                      "excess, %",
                                      "outline: mean, pixels",
                                      "95 %"};
  if (evaluate_.photometric) {
    heading.insert(heading.end(),
                   {"correlation: mean", "10 %", "compared, %", "support"});
  }
  return TextTable(std::move(heading));
}

std::vector<JudgedMesh> MeshEvaluator::Judge(const std::vector<View>& views,
                                             const Context& context,
                                             TextTable* table) {
  std::vector<JudgedMesh> meshes;
  for (const std::filesystem::path& path : mesh_paths_) {
    JudgedMesh mesh;
    mesh.measured = MeasureMesh(
        path, NameAmong(path, mesh_paths_), self_intersections_, context);
    const Phase phase(
        context, fmt::format("evaluation of {}", mesh.measured.result.name));
    mesh.evaluation =
        EvaluateMesh(mesh.measured.mesh, views, evaluate_, context);
    CheckIsSeen(path, mesh.evaluation.silhouettes);
    if (mesh.evaluation.reprojection) {
      mesh.evaluation.reprojection->maps.clear();
    }
    mesh.measured.json.update(EvaluationToJson(mesh.evaluation, views));
    table->AddRow(TableRow(mesh.measured.result.name, mesh.evaluation));
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

void MeshEvaluator::AddToPage(const std::vector<JudgedMesh>& meshes,
                              size_t index,
                              const std::vector<View>& views,
                              const Context& context) {
  const MeasuredMesh& measured = meshes[index].measured;
  const IndexedMesh& mesh = measured.mesh;
  PageMesh page =
      MakePageMesh(measured.result.name, mesh, meshes.size(), context);
  PaintFromPhotographs(mesh, views, context, &page);
  const std::vector<float>& support = meshes[index].evaluation.vertex_support;
  if (meshes.size() > 1) {
    // The first mesh is what the others are compared with, and the second what
    // the first is compared with.
    const MeasuredMesh& other = meshes[index == 0 ? 1 : 0].measured;
    std::vector<float> distances = SignedDistances(
        mesh.positions, other.mesh, RayScene(other.mesh), context);
    if (support.empty()) {
      FindDistancePlaces(mesh, distances, page_.diagonal, context, &page);
    }
    AddDistances(other.result.name, std::move(distances), &page);
  }
  if (!support.empty()) {
    FindUnsupportedPlaces(mesh, support, page_.diagonal, context, &page);
    page.values.push_back({"support", "photographs", support});
  }
  page_.meshes.push_back(std::move(page));
}

void MeshEvaluator::WritePage(const CommandEnvironment& environment,
                              const std::vector<View>& views,
                              const Json& report,
                              AtomicFiles* files) {
  std::string names;
  for (const PageMesh& mesh : page_.meshes) {
    names.append(names.empty() ? "" : ", ").append(mesh.name);
  }
  page_.title = names + (evaluate_.photometric ? ": judged by photographs"
                                               : ": judged by masks");
  page_.compared_with = page_.meshes.front().name;
  page_.procedure = ProcedureOfRun(environment);
  page_.procedure.push_back(
      fmt::format("Views: {} of {}, at the resolution of (2^{})^3 voxels.",
                  views.size(),
                  workspace_path_.string(),
                  image_level_));
  if (evaluate_.photometric) {
    page_.procedure.push_back(fmt::format(
        "Photographs: each is compared with up to {} neighbours at {:g} to "
        "{:g} degrees by zero-mean normalised cross-correlation in windows of "
        "{} x {} pixels.",
        evaluate_.reprojection.num_neighbors,
        evaluate_.reprojection.min_angle,
        evaluate_.reprojection.max_angle,
        2 * ReprojectionOptions::kWindowRadius + 1,
        2 * ReprojectionOptions::kWindowRadius + 1));
    page_.procedure.emplace_back(
        "Colours of the photographs: mean over the three views that see a "
        "vertex most from the front, for every mesh alike. The difference to a "
        "photograph is to these colours.");
  }
  page_.procedure.emplace_back(
      "Alignment: none, the meshes are in the frame of the sparse model. Crop: "
      "none.");
  if (page_.meshes.size() > 1) {
    page_.procedure.push_back(fmt::format(
        "Distances: {} points on each surface; to {}, and of {} to {}. None of "
        "them is declared to be the truth.",
        CompareMeshesOptions().num_samples,
        page_.meshes[0].name,
        page_.meshes[0].name,
        page_.meshes[1].name));
  }
  for (const View& view : views) {
    page_.cameras.push_back(view.cam_from_world);
  }
  page_.command_line = CommandLineOf(environment);
  page_.report = report;
  WriteComparisonPage(html_path_, page_, views, environment.context, files);
}

void MeshEvaluator::WriteFiles(const CommandEnvironment& environment,
                               const std::vector<View>& views,
                               const Json& report) {
  AtomicFiles files;
  if (!html_path_.empty()) {
    WritePage(environment, views, report, &files);
  }
  if (!output_path_.empty()) {
    WriteReport(output_path_, report, &files);
  }
  files.Commit();
}

namespace {

double DiagonalOf(const MeasuredMesh& mesh) {
  return mesh.result.audit.bounding_box.diagonal().norm();
}

// Where no mesh counts as correct, distances are to the first one.
void CompareWithFirst(std::vector<JudgedMesh>* meshes, const Context& context) {
  CompareMeshesOptions options;
  const IndexedMesh& first = meshes->front().measured.mesh;
  for (size_t i = 1; i < meshes->size(); ++i) {
    MeasuredMesh& measured = (*meshes)[i].measured;
    const Phase phase(context, fmt::format("Compare {}", measured.result.name));
    measured.json["comparison"] =
        DistancesToJson(CompareMeshes(measured.mesh, first, options, context));
  }
}

Json Rank(const std::vector<JudgedMesh>& meshes, uint64_t seed) {
  std::vector<SupportedMesh> supported;
  supported.reserve(meshes.size());
  for (const JudgedMesh& mesh : meshes) {
    supported.push_back(
        {mesh.measured.result.name, mesh.evaluation.view_support});
  }
  return RankBySupport(supported, seed);
}

}  // namespace

void MeshEvaluator::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  evaluate_.Check();
  evaluate_.reprojection.keep_maps = evaluate_.photometric;
  CheckOption(image_level_ >= 1 && image_level_ <= 20,
              "image_level",
              image_level_,
              "must be in 1 .. 20");
  mesh_paths_ = SplitPaths("mesh_path", mesh_paths_);
  FileRoles files(environment.options);
  for (const std::filesystem::path& path : mesh_paths_) {
    files.Read(path, "a mesh to evaluate");
  }
  files.Write("output_path", output_path_, "the report");
  CheckPagePath(html_path_, &files);
  files.Guard(&loading_.workspace);
  loading_.load_images = evaluate_.photometric;
  // A mesh is judged by what it is given.
  loading_.keep_all_views = true;
  loading_.region.bounding_box = OptionalBoundingBox(bounding_box_);
  const LoadedScene loaded =
      LoadScene(workspace_path_, loading_, image_level_, context);
  const std::vector<View>& views = loaded.scene.views;
  TextTable table = MakeTable();
  std::vector<JudgedMesh> meshes = Judge(views, context, &table);
  environment.out << table.ToString();
  Json ranking;
  if (evaluate_.photometric && meshes.size() > 1) {
    ranking = Rank(meshes, context.Seed());
    environment.out << '\n' << RankingText(ranking);
  }
  if (output_path_.empty() && html_path_.empty()) {
    return;
  }
  if (!html_path_.empty()) {
    CompareWithFirst(&meshes, context);
    page_.diagonal = DiagonalOf(meshes.front().measured);
    for (size_t i = 0; i < meshes.size(); ++i) {
      AddToPage(meshes, i, views, context);
      const PageMesh& added = page_.meshes.back();
      meshes[i].measured.json["places"] =
          PlacesToJson(added.places, added.place_kind);
    }
  }
  Json report = MakeReport(environment);
  report["input"] = LoadSummaryToJson(loaded.summary, loaded.region);
  report["meshes"] = Json::array();
  for (JudgedMesh& mesh : meshes) {
    report["meshes"].push_back(std::move(mesh.measured.json));
  }
  if (!ranking.is_null()) {
    report["ranking"] = std::move(ranking);
  }
  WriteFiles(environment, views, report);
}

}  // namespace

std::unique_ptr<Command> MakeMeshEvaluator() {
  return std::make_unique<MeshEvaluator>();
}

}  // namespace octacut
