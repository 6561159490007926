#include "plugin/commands/mesh_comparer.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/mesh/mesh_io.h"
#include "colmap_io/model/read_sparse_model.h"
#include "core/base/error.h"
#include "core/compare/compare_meshes.h"
#include "core/compare/seen_reference.h"
#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"
#include "plugin/comparison_tables.h"
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
  // A mesh with what is said of it on its own.
  struct Measured {
    IndexedMesh mesh;
    ComparedMesh result;
    Json json;
  };

  void CheckPaths() const;
  ReferenceFilter SeenPart(const IndexedMesh& reference) const;
  Measured Measure(const fs::path& path, const Context& context) const;
  std::string NameOf(const fs::path& path) const;

  std::vector<fs::path> input_paths_;
  fs::path reference_path_;
  fs::path output_path_;
  bool self_intersections_ = true;
  fs::path views_path_;
  SeenReferenceOptions seen_;
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

// A report that replaced one of the meshes would be a bad surprise.
void MeshComparer::CheckPaths() const {
  if (output_path_.empty()) {
    return;
  }
  std::vector<fs::path> meshes = input_paths_;
  meshes.push_back(reference_path_);
  for (const fs::path& mesh : meshes) {
    std::error_code ignored;
    if (fs::equivalent(mesh, output_path_, ignored)) {
      throw OptionError(
          fmt::format("output_path = {}: must not be a mesh of "
                      "the comparison",
                      output_path_.string()));
    }
  }
  CheckFilePath(output_path_);
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

// The file's name, or the whole path where that is not enough.
std::string MeshComparer::NameOf(const fs::path& path) const {
  size_t num_equal = 0;
  for (const fs::path& other : input_paths_) {
    num_equal += other.filename() == path.filename();
  }
  return num_equal > 1 ? path.string() : path.filename().string();
}

MeshComparer::Measured MeshComparer::Measure(const fs::path& path,
                                             const Context& context) const {
  const Phase phase(context, fmt::format("Examine {}", NameOf(path)));
  MeshFile file = ReadMesh(path);
  for (const std::string& note : file.notes) {
    context.Info(fmt::format("{}: {}", path.string(), note));
  }
  if (file.mesh.triangles.empty()) {
    throw InputError(
        fmt::format("{}: has no faces, only {} vertices; a surface is needed",
                    path.string(),
                    file.mesh.positions.size()));
  }
  Measured measured;
  measured.result.name = NameOf(path);
  measured.result.audit = AuditMesh(file.mesh, context);
  measured.json["path"] = path.string();
  measured.json["notes"] = file.notes;
  measured.json["audit"] = AuditToJson(measured.result.audit);
  if (self_intersections_) {
    measured.result.self_intersections =
        FindSelfIntersections(file.mesh, context);
    measured.json["self_intersections"] =
        SelfIntersectionsToJson(*measured.result.self_intersections);
  }
  measured.mesh = std::move(file.mesh);
  return measured;
}

void MeshComparer::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  compare_.Check();
  seen_.Check();
  CheckPaths();
  Measured reference = Measure(reference_path_, context);
  if (!views_path_.empty()) {
    compare_.reference_filter = SeenPart(reference.mesh);
  }
  reference.result.name += " (reference)";
  std::vector<ComparedMesh> results;
  Json meshes = Json::array();
  for (const fs::path& path : input_paths_) {
    Measured measured = Measure(path, context);
    const Phase phase(context, fmt::format("Compare {}", NameOf(path)));
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
