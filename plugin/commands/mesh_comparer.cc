#include "plugin/commands/mesh_comparer.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/read_sparse_model.h"
#include "core/benchmark/compare/compare_meshes.h"
#include "core/benchmark/compare/seen_reference.h"
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
  bool UsesRandomSeed() const override { return true; }
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
  options.AddRequiredRepeatable("input_path",
                                &input_paths_,
                                "Mesh to compare (.ply, .obj, .off or .stl).");
  options.AddRequired("reference_path",
                      &reference_path_,
                      "Reference mesh, which counts as correct.");
  options.Add(
      "output_path", &output_path_, "JSON report to write. Default: none.");
  options
      .Add("num_samples",
           &compare_.num_samples,
           "Number of points on each surface whose distances are measured.")
      .ForExperts();
  options
      .Add("thresholds",
           &compare_.thresholds,
           "Distance thresholds of precision, recall and F-score, as "
           "fractions of the reference's bounding box diagonal.")
      .ForExperts();
  options
      .Add("accuracy_fraction",
           &compare_.accuracy_fraction,
           "Fraction of a mesh that is used for its accuracy: accuracy is "
           "the distance within which this fraction lies.")
      .ForExperts();
  options
      .Add("completeness_threshold",
           &compare_.completeness_threshold,
           "Distance threshold of completeness, as a fraction of the "
           "reference's bounding box diagonal.")
      .ForExperts();
  options
      .Add("self_intersections",
           &self_intersections_,
           "If 1, count the triangles of each mesh that intersect others of "
           "the same mesh.")
      .ForExperts();
  options.Add(
      "views_path",
      &views_path_,
      "Folder of a sparse model in the frame of the reference. If given, only "
      "the part of the reference that its cameras see is compared.");
  options
      .Add("min_views",
           &seen_.min_views,
           "Number of cameras that must see a point. Used with views_path.")
      .ForExperts();
  options
      .Add("max_view_angle",
           &seen_.max_angle,
           "Maximum angle in degrees between viewing direction and surface "
           "normal. Used with views_path.")
      .ForExperts();
  options.Add("bounding_box",
              &bounding_box_,
              "Box x0,y0,z0,x1,y1,z1 in the frame of the reference. If given, "
              "only the part of the reference inside it is compared.");
  options.Add("align",
              &compare_.align,
              "If 1, register each mesh with the reference first (ICP). Both "
              "must be nearly aligned already.");
  options
      .Add("Alignment.num_samples",
           &compare_.alignment.num_samples,
           "Number of points on each surface that are used for registration.")
      .ForExperts();
  options.AddConstant("Alignment.max_iterations",
                      compare_.alignment.max_iterations);
  options.AddConstant("Alignment.kept_fraction",
                      compare_.alignment.kept_fraction);
  options
      .Add("Alignment.estimate_scale",
           &compare_.alignment.estimate_scale,
           "If 0, estimate only rotation and translation.")
      .ForExperts();
  options.AddConstant("Alignment.tolerance", compare_.alignment.tolerance);
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
        "\ncompared: {:.1f} % of the reference's area\n",
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
