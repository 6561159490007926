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
#include "plugin/benchmark_protocol.h"
#include "plugin/comparison_options.h"
#include "plugin/comparison_tables.h"
#include "plugin/file_roles.h"
#include "plugin/judged_part.h"
#include "plugin/measured_mesh.h"
#include "plugin/mesh_json.h"
#include "plugin/page/comparison_protocol.h"
#include "plugin/page/page_builder.h"
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
  void ShowDistances(const MeasuredMesh& measured,
                     const MeasuredMesh& reference,
                     const Context& context);
  fs::path DistancePath(const fs::path& mesh) const;
  void CheckPaths() const;
  void PrintTables(const ComparedMesh& reference, std::ostream& out) const;
  void WritePage(const CommandEnvironment& environment, const Json& report);
  // A protocol has scores of its own.
  bool HasScores() const {
    return reference_is_truth_ && !protocol_run_->IsActive();
  }
  std::vector<std::string> Protocol(
      const CommandEnvironment& environment) const;

  std::vector<fs::path> input_paths_;
  fs::path reference_path_;
  fs::path output_path_;
  bool self_intersections_ = true;
  JudgedPartOptions judged_;
  CompareMeshesOptions compare_;
  ProtocolOptions protocol_;
  std::optional<ProtocolRun> protocol_run_;
  // Those of the compared meshes, if there is a protocol.
  std::vector<std::pair<std::string, ProtocolResult>> protocol_results_;
  bool reference_is_truth_ = true;
  fs::path html_path_;
  fs::path transform_path_;
  fs::path transform_output_path_;
  fs::path distance_path_;
  // Results for the compared meshes, in the order of input_paths_.
  std::vector<ComparedMesh> results_;
  Similarity3d given_transform_;
  std::optional<SharedCameraAlignment> shared_cameras_;
  ComparisonPage page_;
  PageMesh reference_page_;
};

void MeshComparer::DeclareOptions(OptionManager& options) {
  options.AddRequiredRepeatable("input_path",
                                &input_paths_,
                                "Mesh or point cloud to compare (.ply, .obj, "
                                ".off or .stl), or several separated by "
                                "commas.");
  options.AddRequired("reference_path",
                      &reference_path_,
                      "Reference mesh or point cloud (for eth3d, the scans' "
                      ".mlp project).");
  options.Add(
      "output_path", &output_path_, "JSON report to write. Default: none.");
  options.Add(
      "html_path",
      &html_path_,
      "HTML page to write: a viewer for the meshes and their distances. "
      "Default: none.");
  options.Add(
      "transform_path",
      &transform_path_,
      "Text file with a 4 x 4 matrix, row by row, by which the compared "
      "meshes are moved first. Default: none.");
  options
      .Add("transform_output_path",
           &transform_output_path_,
           "Text file to write: the 4 x 4 matrix that brings the mesh, one "
           "only, into the frame of the reference. Used with align.")
      .ForExperts();
  options
      .Add("distance_path",
           &distance_path_,
           "Folder in which each compared mesh is saved with its signed "
           "distance to the reference at every vertex (.ply, property quality, "
           "for MeshLab and CloudCompare). Default: none.")
      .ForExperts();
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
  if (!transform_path_.empty()) {
    given_transform_ = ReadTransform(transform_path_);
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
                     NameAmong(path, input_paths_),
                     self_intersections_,
                     context,
                     AllowClouds::kYes);
}

MeasuredMesh MeshComparer::MeasureReference(const Context& context) {
  std::optional<IndexedMesh> scans =
      protocol_run_->ReadReference(reference_path_);
  return scans ? MeasureMesh(std::move(*scans),
                             reference_path_,
                             NameAmong(reference_path_, input_paths_),
                             self_intersections_,
                             context)
               : Measure(reference_path_, context);
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
    CheckOverlap(path, measured.mesh, reference_path_, reference.mesh);
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
  if (!html_path_.empty() || !distance_path_.empty()) {
    ShowDistances(measured, reference, context);
  }
  if (!html_path_.empty()) {
    measured.json["places"] = PlacesToJson(page_.meshes.back());
  }
  if (!transform_output_path_.empty()) {
    WriteTransform(
        transform_output_path_,
        (comparison.alignment
             ? comparison.alignment->reference_from_mesh
             : *protocol_results_.back().second.reference_from_mesh) *
            given_transform_);
  }
  results_.push_back(std::move(measured.result));
  return std::move(measured.json);
}

void MeshComparer::ShowDistances(const MeasuredMesh& measured,
                                 const MeasuredMesh& reference,
                                 const Context& context) {
  const MeshComparison& comparison = *measured.result.comparison;
  const IndexedMesh moved =
      comparison.alignment
          ? TransformMesh(measured.mesh,
                          comparison.alignment->reference_from_mesh)
          : measured.mesh;
  const std::string& name = measured.result.name;
  const IndexedMesh surface = PointsAsTriangles(reference.mesh);
  const std::vector<float> distances =
      SignedDistances(moved.positions,
                      surface,
                      RayScene(surface),
                      context,
                      compare_.reference_filter);
  if (!distance_path_.empty()) {
    WriteMeshWithValues(DistancePath(measured.json["path"].get<std::string>()),
                        moved,
                        distances,
                        "quality");
  }
  if (html_path_.empty()) {
    return;
  }
  PageMesh page = MakePageMesh(name, moved, input_paths_.size() + 1, context);
  FindDistancePlaces(
      moved, distances, comparison.reference_diagonal, context, &page);
  AddDistances(reference.result.name, distances, &page);
  page_.meshes.push_back(std::move(page));
  if (reference_page_.values.empty()) {
    const IndexedMesh other = PointsAsTriangles(moved);
    std::vector<float> back = SignedDistances(
        reference.mesh.positions, other, RayScene(other), context);
    DropUnjudged(surface, compare_.reference_filter, &back);
    AddDistances(name, std::move(back), &reference_page_);
  }
  page_.diagonal = comparison.reference_diagonal;
}

fs::path MeshComparer::DistancePath(const fs::path& mesh) const {
  return distance_path_ / (mesh.stem().string() + "-distance.ply");
}

void MeshComparer::CheckPaths() const {
  CheckOption(judged_.input_views_path.empty() || transform_path_.empty(),
              "input_views_path",
              judged_.input_views_path.string(),
              "cannot be used together with transform_path");
  FileRoles files;
  for (const fs::path& path : input_paths_) {
    files.Read(path, "a mesh to compare");
  }
  for (const fs::path& path : protocol_.crop_paths) {
    files.Read(path, "the crop");
  }
  files.Read(reference_path_, "the reference");
  files.Read(transform_path_, "the transform to read");
  files.Write("output_path", output_path_, "the report");
  CheckPagePath(html_path_, &files);
  CheckOption(transform_output_path_.empty() ||
                  ((compare_.align || protocol_run_->Aligns()) &&
                   input_paths_.size() == 1),
              "transform_output_path",
              transform_output_path_.string(),
              "needs align = 1 or a protocol that aligns, and a single "
              "input_path");
  files.Write(
      "transform_output_path", transform_output_path_, "the transform found");
  if (!distance_path_.empty()) {
    for (const fs::path& path : input_paths_) {
      files.Write(
          "distance_path", DistancePath(path), "the distances of another mesh");
    }
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

std::vector<std::string> MeshComparer::Protocol(
    const CommandEnvironment& environment) const {
  std::vector<std::string> lines = ProtocolOfRun(environment);
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
      lines.push_back(AlignmentLine(
          mesh.name, *alignment, compare_.alignment, page_.diagonal));
    }
  }
  if (!transform_path_.empty()) {
    lines.push_back(
        fmt::format("Transform: the compared meshes were moved by "
                    "the matrix in {}.",
                    transform_path_.string()));
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
                             const Json& report) {
  page_.title = fmt::format(
      "{} and {}",
      fmt::join(NamesOf(results_), ", "),
      reference_page_.name + (reference_is_truth_ ? " (truth)" : ""));
  page_.has_truth = reference_is_truth_;
  page_.compared_with = reference_page_.name;
  page_.meshes.push_back(std::move(reference_page_));
  page_.protocol = Protocol(environment);
  page_.command_line = CommandLineOf(environment);
  page_.report = report;
  WriteComparisonPage(html_path_, page_, {}, environment.context);
}

void MeshComparer::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  compare_.Check();
  judged_.Check();
  input_paths_ = SplitPaths("input_path", input_paths_);
  protocol_.crop_paths = SplitPaths("crop_path", protocol_.crop_paths);
  CheckProtocolOptions(protocol_, reference_path_, environment.options);
  protocol_run_.emplace(protocol_);
  CheckPaths();
  CheckOption(compare_.align || !compare_.alignment.global_search,
              "Alignment.global_search",
              1,
              "needs align = 1");
  SparseModel views;
  if (!judged_.views_path.empty()) {
    views = ReadLargestModel(judged_.views_path,
                             "views_path " + judged_.views_path.string(),
                             context);
    for (const SparseImage& image : views.images) {
      page_.cameras.push_back(image.CamFromWorld());
    }
  }
  FindGivenTransform(views, context);
  MeasuredMesh reference = MeasureReference(context);
  compare_.reference_filter = JudgedPart(reference.mesh, views, judged_);
  if (!html_path_.empty()) {
    reference_page_ = MakePageMesh(reference.result.name,
                                   reference.mesh,
                                   input_paths_.size() + 1,
                                   context);
    reference_page_.is_reference = true;
  }
  Json meshes = Json::array();
  for (const fs::path& path : input_paths_) {
    meshes.push_back(CompareOne(path, reference, context));
  }
  ComparedMesh named = reference.result;
  named.name += " (reference)";
  PrintTables(named, environment.out);
  if (!output_path_.empty() || !html_path_.empty()) {
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
    if (!html_path_.empty()) {
      WritePage(environment, report);
    }
    if (!output_path_.empty()) {
      WriteReport(output_path_, report);
    }
  }
}

}  // namespace

std::unique_ptr<Command> MakeMeshComparer() {
  return std::make_unique<MeshComparer>();
}

}  // namespace octacut
