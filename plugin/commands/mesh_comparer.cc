#include "plugin/commands/mesh_comparer.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/read_sparse_model.h"
#include "core/compare/compare_meshes.h"
#include "core/compare/seen_reference.h"
#include "core/scene/region.h"
#include "plugin/comparison_tables.h"
#include "plugin/measured_mesh.h"
#include "plugin/mesh_json.h"
#include "plugin/report.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

class MeshComparer : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  // Which part of the reference is judged; empty where all of it is.
  ReferenceFilter JudgedPart(const IndexedMesh& reference) const;
  ReferenceFilter SeenPart(const IndexedMesh& reference) const;
  MeasuredMesh Measure(const fs::path& path, const Context& context) const;

  std::vector<fs::path> input_paths_;
  fs::path reference_path_;
  fs::path output_path_;
  bool self_intersections_ = true;
  fs::path views_path_;
  SeenReferenceOptions seen_;
  std::vector<double> bounding_box_;
  CompareMeshesOptions compare_;
};

void MeshComparer::DeclareOptions(OptionManager& options) {
  options.AddRequiredRepeatable(
      "input_path", &input_paths_, "Mesh to judge: .ply, .obj, .off or .stl");
  options.AddRequired("reference_path", &reference_path_, "Mesh that is right");
  options.Add("output_path", &output_path_, "JSON report; empty: none");
  options.Add("num_samples",
              &compare_.num_samples,
              "Points on each surface whose distances are measured");
  options.Add("thresholds",
              &compare_.thresholds,
              "Of precision, recall and F-score, as fractions of the "
              "reference's diagonal");
  options.Add("accuracy_fraction",
              &compare_.accuracy_fraction,
              "Accuracy is the distance that this fraction of a mesh keeps");
  options.Add("completeness_threshold",
              &compare_.completeness_threshold,
              "Completeness is the part of the reference within this fraction "
              "of its diagonal");
  options.Add("self_intersections",
              &self_intersections_,
              "1: count the triangles that intersect others of their mesh");
  options.Add("views_path",
              &views_path_,
              "Folder of a sparse model in the reference's frame: only what "
              "its cameras see of the reference counts; empty: all does");
  options.Add("min_views",
              &seen_.min_views,
              "With views_path: cameras that must see a point");
  options.Add("max_view_angle",
              &seen_.max_angle,
              "With views_path: of a view to the normal, degrees");
  options.Add("bounding_box",
              &bounding_box_,
              "x0,y0,z0,x1,y1,z1 in the reference's frame: only what is in it "
              "of the reference counts; empty: all does");
  options.Add("align",
              &compare_.align,
              "1: move each mesh onto the reference first (ICP); the two must "
              "nearly agree already");
  options.Add("Alignment.num_samples",
              &compare_.alignment.num_samples,
              "Points on each surface");
  options.Add("Alignment.max_iterations",
              &compare_.alignment.max_iterations,
              "At most so many");
  options.Add("Alignment.kept_fraction",
              &compare_.alignment.kept_fraction,
              "Of the pairs of points the closest ones, the rest is left out");
  options.Add("Alignment.estimate_scale",
              &compare_.alignment.estimate_scale,
              "0: rotation and translation only");
  options.Add("Alignment.tolerance",
              &compare_.alignment.tolerance,
              "Ends when nothing moves further, fraction of the size");
}

ReferenceFilter MeshComparer::SeenPart(const IndexedMesh& reference) const {
  const SparseModel model = ReadSparseModel(views_path_);
  std::vector<PosedCamera> cameras;
  for (const SparseImage& image : model.images) {
    cameras.push_back({UndistortedCamera(*model.FindCamera(image.camera_id)),
                       image.CamFromWorld()});
  }
  return SeenByCameras(reference, std::move(cameras), seen_);
}

ReferenceFilter MeshComparer::JudgedPart(const IndexedMesh& reference) const {
  const ReferenceFilter seen =
      views_path_.empty() ? ReferenceFilter() : SeenPart(reference);
  if (bounding_box_.empty()) {
    return seen;
  }
  return [seen, box = BoundingBoxFromNumbers(bounding_box_)](
             uint32_t triangle, const Eigen::Vector3d& point) {
    return box.contains(point) && (!seen || seen(triangle, point));
  };
}

MeasuredMesh MeshComparer::Measure(const fs::path& path,
                                   const Context& context) const {
  return MeasureMesh(
      path, NameAmong(path, input_paths_), self_intersections_, context);
}

void MeshComparer::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  compare_.Check();
  seen_.Check();
  std::vector<fs::path> meshes_read = input_paths_;
  meshes_read.push_back(reference_path_);
  CheckReportPath(output_path_, meshes_read);
  MeasuredMesh reference = Measure(reference_path_, context);
  compare_.reference_filter = JudgedPart(reference.mesh);
  reference.result.name += " (reference)";
  std::vector<ComparedMesh> results;
  Json meshes = Json::array();
  for (const fs::path& path : input_paths_) {
    MeasuredMesh measured = Measure(path, context);
    const Phase phase(context, fmt::format("Compare {}", measured.result.name));
    measured.result.comparison =
        CompareMeshes(measured.mesh, reference.mesh, compare_, context);
    measured.json["comparison"] = ComparisonToJson(*measured.result.comparison);
    meshes.push_back(std::move(measured.json));
    results.push_back(std::move(measured.result));
  }

  std::vector<ComparedMesh> all = results;
  all.push_back(reference.result);
  environment.out << TopologyTable(all) << '\n';
  const std::string alignment = AlignmentTable(results);
  if (!alignment.empty()) {
    environment.out << alignment << '\n';
  }
  environment.out << DistanceTable(results) << '\n'
                  << ScoreTable(results, compare_);
  const std::string confidence = ConfidenceTable(results);
  if (!confidence.empty()) {
    environment.out << '\n' << confidence;
  }
  if (compare_.reference_filter) {
    environment.out << fmt::format(
        "\njudged: {:.1f} % of the reference's area\n",
        100 * results.front().comparison->judged_share);
  }
  if (!output_path_.empty()) {
    Json report = MakeReport(environment);
    report["reference"] = std::move(reference.json);
    report["meshes"] = std::move(meshes);
    WriteReport(output_path_, report);
  }
}

}  // namespace

std::unique_ptr<Command> MakeMeshComparer() {
  return std::make_unique<MeshComparer>();
}

}  // namespace octacut
