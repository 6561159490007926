#include "plugin/commands/mesh_exporter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <utility>

#include "colmap_io/images/workspace.h"
#include "colmap_io/mesh/mesh_io.h"
#include "colmap_io/model/camera_projector.h"
#include "core/base/check_option.h"
#include "core/base/median.h"
#include "core/mesh/audit.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/normals.h"
#include "core/mesh/self_intersections.h"
#include "core/mesh/untangle.h"
#include "core/print/flat_base.h"
#include "core/print/place_on_plate.h"
#include "core/print/resting_plane.h"
#include "plugin/closed_mesh.h"
#include "plugin/export_scale.h"
#include "plugin/file_roles.h"
#include "plugin/mesh_json.h"
#include "plugin/print_json.h"
#include "plugin/report.h"
#include "plugin/transform_file.h"
#include "plugin/vector_json.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// The share of the height that is cut off unless the user says otherwise: more
// than the unevenness of the lowest few voxels of 512, and the sole of a ball
// gets a fifth of its width.
constexpr double kBaseDepth = 0.01;
constexpr const char* kStand = "stand";

class MeshExporter : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  bool UsesRandomSeed() const override { return true; }
  void Run(const CommandEnvironment& environment) override;

 private:
  void Check(const OptionManager& options) const;
  std::optional<Workspace> OpenIfNeeded(const Context& context) const;
  // Up in the frame of the mesh; adds what was found to the report.
  Eigen::Vector3d FindUp(const IndexedMesh& mesh,
                         const std::optional<Workspace>& workspace,
                         const Context& context,
                         Json* json) const;
  // The mesh as it is printed; lowers `plate_from_mesh` by what is cut off.
  IndexedMesh MakePrint(const IndexedMesh& mesh,
                        const Context& context,
                        Similarity3d* plate_from_mesh,
                        Json* json) const;

  fs::path input_path_;
  fs::path output_path_;
  fs::path report_path_;
  fs::path workspace_path_;
  WorkspaceOptions workspace_;
  ExportScaleOptions scale_;
  std::string up_;
  bool flat_base_ = false;
  double base_depth_ = 0;
};

void MeshExporter::DeclareOptions(OptionManager& options) {
  options.AddRequired("input_path",
                      &input_path_,
                      "Closed mesh in the frame of the sparse model (.ply, "
                      ".obj, .off or .stl).");
  options.AddRequired("output_path",
                      &output_path_,
                      "File to write (.3mf, .stl, .ply, .obj or .off). The "
                      "mesh stands on z = 0, in millimetres.");
  options
      .Add("report_path",
           &report_path_,
           "JSON report to write, with the 4 x 4 matrix from the frame of the "
           "mesh to that of the file. Default: the output path followed by "
           ".json.")
      .ForExperts();
  scale_.Declare(options);
  options.Add(
      "up",
      &up_,
      "Upward direction: x,y,z in the frame of the mesh, or `stand`, the "
      "normal of the plane of sparse points under the object. Default: "
      "0,0,1.");
  options.Add("flat_base",
              &flat_base_,
              "If 1, cut the object off at the bottom and close it with a flat "
              "base.");
  options.Add(
      "base_depth",
      &base_depth_,
      "How far above the lowest point to cut, in millimetres. With 0, it "
      "is 1 % of the height.");
  options.Add("workspace_path",
              &workspace_path_,
              "Folder of the COLMAP project, for aruco_side and up stand.");
  options
      .Add("image_path",
           &workspace_.image_path,
           "Folder of the photographs. Default: images in the workspace.")
      .ForExperts();
  options
      .Add("sparse_path",
           &workspace_.input_path,
           "Folder of the sparse model. Default: the model in the workspace "
           "that has the most images.")
      .ForExperts();
}

// An empty text is the z-axis.
Eigen::Vector3d ParseUp(const std::string& text) {
  if (text.empty() || text == kStand) {
    return Eigen::Vector3d::UnitZ();
  }
  std::array<double, 3> numbers = {0, 0, 0};
  try {
    ParseOptionValue(text, &numbers);
  } catch (const OptionError&) {
    numbers = {0, 0, 0};
  }
  Eigen::Vector3d up = Eigen::Vector3d(numbers.data());
  CheckOption(up.allFinite() && up.stableNorm() > 0,
              "up",
              text,
              "must be a direction x,y,z that is not zero, or stand");
  return up;
}

void MeshExporter::Check(const OptionManager& options) const {
  scale_.Check();
  ParseUp(up_);
  CheckOption(base_depth_ >= 0 && std::isfinite(base_depth_),
              "base_depth",
              base_depth_,
              "must not be negative");
  CheckOption(base_depth_ == 0 || flat_base_,
              "base_depth",
              base_depth_,
              "needs --flat_base 1");
  if (!scale_.NeedsWorkspace() && up_ != kStand) {
    options.RefuseUnused({"workspace_path", "image_path", "sparse_path"},
                         "aruco_side or --up stand");
  } else if (workspace_path_.empty()) {
    throw OptionError(
        "--workspace_path must be given for --aruco_side and --up stand");
  }
}

std::optional<Workspace> MeshExporter::OpenIfNeeded(
    const Context& context) const {
  if (!scale_.NeedsWorkspace() && up_ != kStand) {
    return std::nullopt;
  }
  WorkspaceOptions options = workspace_;
  options.needs_images = scale_.NeedsWorkspace();
  options.needs_masks = false;
  return OpenWorkspace(workspace_path_, options, context);
}

// The error of the points: what their reprojection errors are at the distance
// of the object.
Surroundings SurroundingsOf(const IndexedMesh& mesh, const SparseModel& model) {
  const Eigen::AlignedBox3d box = BoundingBox(mesh);
  Surroundings surroundings;
  std::vector<double> pixels;
  for (const SparseImage& image : model.images) {
    const Eigen::Vector3d center = image.CamFromWorld().Inverse().translation;
    surroundings.camera_centers.push_back(center);
    const CameraProjector projector(*model.FindCamera(image.camera_id));
    pixels.push_back((center - box.center()).norm() /
                     projector.Intrinsics().fx);
  }
  std::vector<double> errors;
  for (const SparsePoint& point : model.points) {
    surroundings.points.push_back(point.xyz);
    errors.push_back(point.error >= 0 ? point.error : 1);
  }
  if (!pixels.empty() && !errors.empty()) {
    surroundings.noise = Median(std::move(pixels)) * Median(std::move(errors));
  }
  return surroundings;
}

Eigen::Vector3d MeshExporter::FindUp(const IndexedMesh& mesh,
                                     const std::optional<Workspace>& workspace,
                                     const Context& context,
                                     Json* json) const {
  Eigen::Vector3d up = ParseUp(up_);
  if (up_ == kStand) {
    const RestingPlane stand =
        NamingErrors(workspace.value().model_path.string(), [&] {
          return FindRestingPlane(
              mesh, SurroundingsOf(mesh, workspace.value().model), context);
        });
    up = stand.up;
    context.Info(fmt::format(
        "{} of {} sparse points around the object lie in the plane of the "
        "stand. The upward direction is {:.4f}, {:.4f}, {:.4f}.",
        stand.num_points,
        stand.num_candidates,
        up.x(),
        up.y(),
        up.z()));
    (*json)["stand"] = {{"points", stand.num_points},
                        {"candidates", stand.num_candidates},
                        {"rms", stand.rms},
                        {"gap", stand.gap},
                        {"offset", stand.offset}};
  }
  up.stableNormalize();
  (*json)["up"] = VectorToJson(up);
  return up;
}

double HeightOf(const IndexedMesh& mesh, const Similarity3d& plate_from_mesh) {
  double height = 0;
  for (const Eigen::Vector3d& position : mesh.positions) {
    height = std::max(height, (plate_from_mesh * position).z());
  }
  return height;
}

IndexedMesh MeshExporter::MakePrint(const IndexedMesh& mesh,
                                    const Context& context,
                                    Similarity3d* plate_from_mesh,
                                    Json* json) const {
  const double height = HeightOf(mesh, *plate_from_mesh);
  const double depth = !flat_base_       ? 0
                       : base_depth_ > 0 ? base_depth_
                                         : kBaseDepth * height;
  CheckOption(depth < height,
              "base_depth",
              depth,
              fmt::format("must be less than the height of {:.6g} mm", height));
  plate_from_mesh->translation.z() -= depth;
  IndexedMesh print = TransformMesh(mesh, *plate_from_mesh);
  RoundToFloats(&print.positions);
  if (flat_base_) {
    FlatBase base = CutFlatBase(print, context);
    (*json)["flat_base"] = {
        {"depth", depth}, {"area", base.area}, {"islands", base.num_islands}};
    print = std::move(base.mesh);
  }
  if (!print.normals.empty() || flat_base_) {
    print.normals = ComputeVertexNormals(print, context);
  }
  return print;
}

void MeshExporter::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  Check(environment.options);
  if (report_path_.empty()) {
    report_path_ = output_path_.string() + ".json";
  }
  CheckMeshPath(output_path_);
  CheckOption(MeshFormatOf(output_path_) != MeshFormat::kGlb,
              "output_path",
              output_path_.string(),
              "must not be a .glb file, whose units are metres");
  FileRoles files(environment.options);
  files.Read(input_path_, "the mesh to export");
  files.Write("output_path", output_path_, "the file to print");
  files.Write("report_path", report_path_, "the report");
  files.Guard(&workspace_);
  const IndexedMesh mesh = ReadClosedMesh(input_path_, context);
  const std::optional<Workspace> workspace = OpenIfNeeded(context);
  const ExportScale scale = scale_.Find(workspace, context);
  Json json;
  json["scale"] = scale.json;
  const Eigen::Vector3d up = FindUp(mesh, workspace, context, &json);
  Similarity3d plate_from_mesh = PlaceOnPlate(mesh, scale.factor, up);
  const IndexedMesh print = MakePrint(mesh, context, &plate_from_mesh, &json);
  const MeshAudit audit = AuditMesh(print, context);
  const std::string failure = audit.DescribeFailure();
  if (!failure.empty()) {
    throw InputError(
        fmt::format("{}: at this scale, single precision is too coarse; after "
                    "rounding, the mesh has {}",
                    input_path_.string(),
                    failure));
  }
  const SelfIntersections intersections = FindSelfIntersections(print, context);
  if (intersections.num_pairs > 0) {
    context.Warn(fmt::format("{}: {} pairs of triangles intersect",
                             output_path_.string(),
                             intersections.num_pairs));
  }
  AtomicFiles written;
  WriteMesh(output_path_, print, &written);
  Json report = MakeReport(environment);
  report["mesh_path"] = output_path_.string();
  report["unit"] = "millimetre";
  report["file_from_mesh"] = TransformToJson(plate_from_mesh);
  report.update(json);
  report["audit"] = AuditToJson(audit);
  report["self_intersections"] = SelfIntersectionsToJson(intersections);
  WriteReport(report_path_, report, &written);
  written.Commit();
  const Eigen::Vector3d size = audit.bounding_box.sizes();
  environment.out << fmt::format(
      "{}: {} triangles, {:.4g} x {:.4g} x {:.4g} mm, {:.4g} cm^3\n",
      output_path_.string(),
      audit.num_triangles,
      size.x(),
      size.y(),
      size.z(),
      audit.volume / 1000);
}

}  // namespace

std::unique_ptr<Command> MakeMeshExporter() {
  return std::make_unique<MeshExporter>();
}

}  // namespace octacut
