#include "plugin/commands/mesh_comparer.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "colmap_io/images/workspace.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/base/check_option.h"
#include "core/benchmark/compare/compare_meshes.h"
#include "core/benchmark/compare/signed_distance.h"
#include "core/mesh/cloud.h"
#include "core/raycast/ray_scene.h"
#include "plugin/comparer_paths.h"
#include "plugin/comparison_options.h"
#include "plugin/comparison_tables.h"
#include "plugin/judged_part.h"
#include "plugin/measured_mesh.h"
#include "plugin/mesh_json.h"
#include "plugin/page/comparison_procedure.h"
#include "plugin/page/distance_page.h"
#include "plugin/page/page_builder.h"
#include "plugin/protocol_options.h"
#include "plugin/protocol_results.h"
#include "plugin/protocol_run.h"
#include "plugin/report.h"
#include "plugin/shared_views.h"
#include "plugin/transform_file.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

class MeshComparer : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  bool UsesRandomSeed() const override { return true; }
  void Run(const CommandEnvironment& environment) override;

 private:
  // Moves the compared meshes as the user has said.
  void FindGivenTransform(const SparseModel& views, const Context& context);
  MeasuredMesh Measure(const fs::path& path, const Context& context) const;
  MeasuredMesh MeasureReference(const Context& context);
  void MeasureByProtocol(const IndexedMesh& reference,
                         const Context& context,
                         MeasuredMesh* measured);
  Json CompareOne(const fs::path& path,
                  const MeasuredMesh& reference,
                  const Context& context);
  // In files of their own and on the page, where those are asked for.
  void ShowDistances(const MeasuredMesh& reference,
                     const Context& context,
                     MeasuredMesh* measured);
  void PrintTables(const ComparedMesh& reference, std::ostream& out) const;
  void RefuseUnusedOptions(const OptionManager& options) const;
  void WritePage(const CommandEnvironment& environment,
                 const SparseModel& views,
                 const Json& report);
  // A protocol has scores of its own.
  bool HasScores() const {
    return reference_is_truth_ && !protocol_run_->IsActive();
  }
  std::vector<std::string> Procedure(
      const CommandEnvironment& environment) const;

  ComparerPaths paths_;
  AtomicFiles files_;  // all that is written
  bool self_intersections_ = true;
  JudgedPartOptions judged_;
  CompareMeshesOptions compare_;
  ProtocolOptions protocol_;
  std::optional<ProtocolRun> protocol_run_;
  // Those of the compared meshes, if there is a protocol.
  std::vector<std::pair<std::string, ProtocolResult>> protocol_results_;
  bool reference_is_truth_ = true;
  // Results for the compared meshes, in the order of their paths.
  std::vector<ComparedMesh> results_;
  Similarity3d given_transform_;
  std::optional<SharedCameraAlignment> shared_cameras_;
  std::optional<DistancePage> page_;  // if there is to be one
};

void MeshComparer::DeclareOptions(OptionManager& options) {
  DeclareComparerPaths(options, &paths_);
  DeclareProtocolOptions(options, &protocol_);
  options.Add("reference_is_truth",
              &reference_is_truth_,
              "If 0, the reference is one mesh among others: there are "
              "distances, but no scores.");
  DeclareMeasureOptions(options, &compare_);
  options
      .Add("self_intersections",
           &self_intersections_,
           "If 1, count the triangles of each mesh that intersect others of "
           "the same mesh.")
      .ForExperts();
  DeclareJudgedPartOptions(options, &judged_);
  DeclareAlignmentOptions(options, &compare_);
}

void MeshComparer::FindGivenTransform(const SparseModel& views,
                                      const Context& context) {
  if (!paths_.transform.empty()) {
    given_transform_ = ReadTransform(paths_.transform);
  } else if (!judged_.input_views_path.empty()) {
    shared_cameras_ = AlignBySharedViews(
        ReadLargestModel(
            judged_.input_views_path,
            "input_views_path " + judged_.input_views_path.string(),
            context),
        views,
        context);
    given_transform_ = shared_cameras_->reference_from_model;
  }
}

MeasuredMesh MeshComparer::Measure(const fs::path& path,
                                   const Context& context) const {
  return MeasureMesh(path,
                     NameAmong(path, paths_.inputs),
                     self_intersections_,
                     context,
                     AllowClouds::kYes);
}

MeasuredMesh MeshComparer::MeasureReference(const Context& context) {
  std::optional<IndexedMesh> scans =
      protocol_run_->ReadReference(paths_.reference);
  return scans ? MeasureMesh(std::move(*scans),
                             paths_.reference,
                             NameAmong(paths_.reference, paths_.inputs),
                             self_intersections_,
                             context)
               : Measure(paths_.reference, context);
}

// Moves the mesh where the protocol aligns it.
void MeshComparer::MeasureByProtocol(const IndexedMesh& reference,
                                     const Context& context,
                                     MeasuredMesh* measured) {
  ProtocolResult result =
      protocol_run_->Measure(measured->mesh, reference, context);
  measured->json["protocol"] = ProtocolResultToJson(result);
  if (result.reference_from_mesh) {
    measured->mesh =
        TransformMesh(std::move(measured->mesh), *result.reference_from_mesh);
  }
  protocol_results_.emplace_back(measured->result.name, std::move(result));
}

Json MeshComparer::CompareOne(const fs::path& path,
                              const MeasuredMesh& reference,
                              const Context& context) {
  MeasuredMesh measured = Measure(path, context);
  measured.mesh = TransformMesh(std::move(measured.mesh), given_transform_);
  if (!(compare_.align && compare_.alignment.global_search)) {
    CheckOverlap(path, measured.mesh, paths_.reference, reference.mesh);
  }
  const Phase phase(context, fmt::format("Compare {}", measured.result.name));
  if (protocol_run_->IsActive()) {
    MeasureByProtocol(reference.mesh, context, &measured);
  }
  measured.result.comparison =
      CompareMeshes(measured.mesh, reference.mesh, compare_, context);
  const MeshComparison& comparison = *measured.result.comparison;
  measured.json["comparison"] =
      HasScores() ? ComparisonToJson(comparison) : DistancesToJson(comparison);
  if (page_ || !paths_.distance_folder.empty()) {
    ShowDistances(reference, context, &measured);
  }
  if (!paths_.transform_output.empty()) {
    WriteTransform(
        paths_.transform_output,
        (comparison.alignment
             ? comparison.alignment->reference_from_mesh
             : *protocol_results_.back().second.reference_from_mesh) *
            given_transform_,
        &files_);
  }
  results_.push_back(std::move(measured.result));
  return std::move(measured.json);
}

void MeshComparer::ShowDistances(const MeasuredMesh& reference,
                                 const Context& context,
                                 MeasuredMesh* measured) {
  const MeshComparison& comparison = *measured->result.comparison;
  const IndexedMesh moved =
      comparison.alignment
          ? TransformMesh(measured->mesh,
                          comparison.alignment->reference_from_mesh)
          : measured->mesh;
  const IndexedMesh surface = PointsAsTriangles(reference.mesh);
  const std::vector<float> distances =
      SignedDistances(moved.positions,
                      surface,
                      RayScene(surface),
                      context,
                      compare_.reference_filter);
  if (!paths_.distance_folder.empty()) {
    WriteMeshWithValues(
        paths_.DistancesOf(measured->json["path"].get<std::string>()),
        moved,
        distances,
        "quality",
        &files_);
  }
  if (page_) {
    measured->json["places"] = page_->Add(measured->result.name,
                                          moved,
                                          distances,
                                          comparison.reference_diagonal,
                                          compare_.reference_filter,
                                          context);
  }
}

void MeshComparer::PrintTables(const ComparedMesh& reference,
                               std::ostream& out) const {
  std::vector<ComparedMesh> all = results_;
  all.push_back(reference);
  out << TopologyTable(all) << '\n';
  if (protocol_run_->IsActive()) {
    out << ProtocolTable(protocol_, protocol_results_);
    return;
  }
  const std::string alignment = AlignmentTable(results_);
  if (!alignment.empty()) {
    out << alignment << '\n';
  }
  out << DistanceTable(results_);
  if (reference_is_truth_) {
    out << '\n' << ScoreTable(results_, compare_);
    const std::string confidence = ConfidenceTable(results_);
    if (!confidence.empty()) {
      out << '\n' << confidence;
    }
  }
  if (compare_.reference_filter) {
    out << fmt::format("\ncompared: {:.1f} % of the reference's area\n",
                       100 * results_.front().comparison->judged_share);
  }
}

std::vector<std::string> MeshComparer::Procedure(
    const CommandEnvironment& environment) const {
  std::vector<std::string> lines = ProcedureOfRun(environment);
  if (protocol_run_->IsActive()) {
    lines.push_back(ProtocolRules(protocol_));
    lines.emplace_back(
        "Distances, curves and places of this page are of the whole surfaces "
        "and not part of the benchmark's protocol; they are measured as "
        "follows.");
  }
  lines.push_back(SamplingLine(compare_.num_samples));
  for (const ComparedMesh& mesh : results_) {
    if (const auto& alignment = mesh.comparison->alignment) {
      lines.push_back(AlignmentLine(mesh.name,
                                    *alignment,
                                    compare_.alignment,
                                    mesh.comparison->reference_diagonal));
    }
  }
  if (!paths_.transform.empty()) {
    lines.push_back(
        fmt::format("Transform: the compared meshes were moved by "
                    "the matrix in {}.",
                    paths_.transform.string()));
  }
  if (shared_cameras_) {
    lines.push_back(SharedViewsLine(
        *shared_cameras_, judged_.input_views_path, judged_.views_path));
  }
  if (protocol_run_->Aligns()) {
    lines.emplace_back("Alignment: as the protocol has moved the meshes.");
  } else if (!compare_.align) {
    lines.emplace_back("Alignment: none, the meshes are compared as they are.");
  }
  lines.push_back(CropLine({judged_.bounding_box.empty(),
                            judged_.views_path.string(),
                            judged_.seen,
                            results_.front().comparison->judged_share}));
  lines.push_back(SignsLine());
  return lines;
}

void MeshComparer::WritePage(const CommandEnvironment& environment,
                             const SparseModel& views,
                             const Json& report) {
  ComparisonPage page = page_->Take(reference_is_truth_);
  for (const SparseImage& image : views.images) {
    page.cameras.push_back(image.CamFromWorld());
  }
  page.procedure = Procedure(environment);
  page.command_line = CommandLineOf(environment);
  page.report = report;
  WriteComparisonPage(paths_.page, page, {}, environment.context, &files_);
}

void MeshComparer::RefuseUnusedOptions(const OptionManager& options) const {
  if (judged_.views_path.empty()) {
    options.RefuseUnused({"min_views", "max_view_angle"}, "views_path");
  }
  if (!compare_.align) {
    options.RefuseUnused({"Alignment.global_search",
                          "Alignment.num_samples",
                          "Alignment.estimate_scale"},
                         "align 1");
  }
}

void MeshComparer::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  compare_.Check();
  judged_.Check();
  paths_.inputs = SplitPaths("input_path", paths_.inputs);
  protocol_.crop_paths = SplitPaths("crop_path", protocol_.crop_paths);
  CheckProtocolOptions(protocol_, paths_.reference, environment.options);
  protocol_run_.emplace(protocol_);
  CheckOption(judged_.input_views_path.empty() || paths_.transform.empty(),
              "input_views_path",
              judged_.input_views_path.string(),
              "cannot be used together with transform_path");
  CheckComparerPaths(paths_,
                     protocol_.crop_paths,
                     {judged_.views_path, judged_.input_views_path},
                     compare_.align || protocol_run_->Aligns(),
                     environment.options);
  RefuseUnusedOptions(environment.options);
  SparseModel views;
  if (!judged_.views_path.empty()) {
    views = ReadLargestModel(judged_.views_path,
                             "views_path " + judged_.views_path.string(),
                             context);
  }
  FindGivenTransform(views, context);
  MeasuredMesh reference = MeasureReference(context);
  compare_.reference_filter = JudgedPart(reference.mesh, views, judged_);
  if (!paths_.page.empty()) {
    page_.emplace(
        reference.result.name, reference.mesh, paths_.inputs.size(), context);
  }
  Json meshes = Json::array();
  for (const fs::path& path : paths_.inputs) {
    meshes.push_back(CompareOne(path, reference, context));
  }
  ComparedMesh named = reference.result;
  named.name += " (reference)";
  PrintTables(named, environment.out);
  if (page_ || !paths_.report.empty()) {
    Json report = MakeReport(environment);
    report["reference"] = std::move(reference.json);
    report["reference_is_truth"] = reference_is_truth_;
    if (shared_cameras_) {
      report["shared_cameras"] = SharedViewsToJson(*shared_cameras_);
    }
    if (protocol_run_->IsActive()) {
      report["protocol"] = ProtocolToJson(protocol_);
    }
    report["meshes"] = std::move(meshes);
    if (page_) {
      WritePage(environment, views, report);
    }
    if (!paths_.report.empty()) {
      WriteReport(paths_.report, report, &files_);
    }
  }
  files_.Commit();
}

}  // namespace

std::unique_ptr<Command> MakeMeshComparer() {
  return std::make_unique<MeshComparer>();
}

}  // namespace octacut
