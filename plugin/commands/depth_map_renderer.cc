#include "plugin/commands/depth_map_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <system_error>
#include <vector>

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/images/dense_map_file.h"
#include "colmap_io/images/undistorted_camera.h"
#include "core/base/check_option.h"
#include "core/evidence/dense_depths.h"
#include "core/raycast/depth_normals.h"
#include "plugin/read_mesh.h"
#include "plugin/report.h"
#include "plugin/workspace_options.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

enum class DepthSource { kMesh, kSweep };

// Pixels of the mesh that at least one photograph must show: with fewer, the
// mesh is in another frame.
constexpr int kMinPixels = 100;
// What colmap stereo_fusion reads by default.
constexpr const char* kKind = ".geometric.bin";
// Samples of the sweep are up to two pixels apart; planes are fitted to two
// samples around.
constexpr int kPlaneRadius = 4;

class DepthMapRenderer : public Command {
 public:
  void DeclareOptions(OptionManager& options) override;
  void Run(const CommandEnvironment& environment) override;

 private:
  struct MapPaths {
    fs::path depth;
    fs::path normals;
  };
  MapPaths PathsOf(const SparseImage& image) const;
  std::vector<const SparseImage*> WantedImages(const SparseModel& model) const;
  void CheckIsSeen(const IndexedMesh& mesh,
                   const RayScene& rays,
                   const SparseModel& model,
                   const Context& context) const;
  void WriteOrigin(const SparseModel& model) const;
  void RenderMesh(const Workspace& workspace,
                  const std::vector<const SparseImage*>& images,
                  const Context& context);
  void Sweep(const Workspace& workspace,
             const std::vector<const SparseImage*>& images,
             const Context& context);
  void Write(const SparseImage& image, const DepthAndNormals& maps);

  fs::path workspace_path_;
  LoadSceneOptions loading_;
  std::vector<double> bounding_box_;
  fs::path mesh_path_;
  DepthSource source_ = DepthSource::kMesh;
  bool overwrite_ = false;
  DenseDepthsOptions sweep_;
  size_t num_written_ = 0;
  size_t num_depths_ = 0;
};

void DepthMapRenderer::DeclareOptions(OptionManager& options) {
  DeclareLoadingOptions(options, &workspace_path_, &loading_);
  DeclareKeepAllViews(options, &loading_.keep_all_views);
  DeclareBoundingBox(options, &bounding_box_);
  options.AddEnum(
      "source",
      &source_,
      {{"mesh", DepthSource::kMesh}, {"sweep", DepthSource::kSweep}},
      "Where depths come from: the mesh of mesh_path, or "
      "octacut's own depth sweep, which uses no mesh and needs "
      "masks.");
  options.Add("mesh_path",
              &mesh_path_,
              "Mesh to render (.ply, .obj, .off or .stl), in the frame of the "
              "sparse model. Required for source mesh.");
  options.Add("overwrite",
              &overwrite_,
              "If 1, replace maps that exist. They are kept otherwise.");
  options
      .Add("sweep_level",
           &sweep_.level,
           "Depths are looked for on a grid of (2^level)^3 voxels around the "
           "object, 4 to 10.")
      .ForExperts();
}

DepthMapRenderer::MapPaths DepthMapRenderer::PathsOf(
    const SparseImage& image) const {
  const fs::path stereo = workspace_path_ / "stereo";
  return {stereo / "depth_maps" / (image.name + kKind),
          stereo / "normal_maps" / (image.name + kKind)};
}

std::vector<const SparseImage*> DepthMapRenderer::WantedImages(
    const SparseModel& model) const {
  std::vector<const SparseImage*> wanted;
  for (const SparseImage& image : model.images) {
    const MapPaths paths = PathsOf(image);
    if (overwrite_ || !fs::exists(paths.depth) || !fs::exists(paths.normals)) {
      wanted.push_back(&image);
    }
  }
  return wanted;
}

void DepthMapRenderer::Write(const SparseImage& image,
                             const DepthAndNormals& maps) {
  const MapPaths paths = PathsOf(image);
  std::error_code ignored;
  fs::create_directories(paths.depth.parent_path(), ignored);
  fs::create_directories(paths.normals.parent_path(), ignored);
  if (overwrite_ || !fs::exists(paths.depth)) {
    WriteDenseMap(paths.depth, maps.depth);
  }
  if (overwrite_ || !fs::exists(paths.normals)) {
    WriteDenseMap(paths.normals, maps.normals);
  }
  ++num_written_;
  num_depths_ += size_t(cv::countNonZero(maps.depth));
}

// Whoever finds the maps, or what was fused from them, can see where they are
// from. Written before the first map, once the input is known to be usable.
void DepthMapRenderer::WriteOrigin(const SparseModel& model) const {
  const auto num_kept = std::count_if(
      model.images.begin(), model.images.end(), [&](const SparseImage& image) {
        const MapPaths paths = PathsOf(image);
        return !overwrite_ &&
               (fs::exists(paths.depth) || fs::exists(paths.normals));
      });
  const fs::path path = workspace_path_ / "stereo" / "octacut-depths.json";
  Json origin;
  origin["program"] = "octacut";
  origin["version"] = OctacutVersion();
  origin["source"] = source_ == DepthSource::kMesh ? "mesh" : "sweep";
  origin["mesh_path"] = mesh_path_.string();
  origin["kept_maps"] = num_kept;
  if (num_kept > 0) {
    std::ifstream stream(path);
    const Json earlier = Json::parse(stream, nullptr, false);
    if (earlier.is_object()) {
      // Maps of an earlier run are octacut's, too.
      origin["kept_maps"] = earlier.value("kept_maps", Json(0));
      origin["earlier"] = earlier;
    }
  }
  WriteReport(path, origin);
}

void DepthMapRenderer::CheckIsSeen(const IndexedMesh& mesh,
                                   const RayScene& rays,
                                   const SparseModel& model,
                                   const Context& context) const {
  for (const SparseImage& image : model.images) {
    const DepthAndNormals maps = RenderDepthAndNormals(
        mesh,
        rays,
        UndistortedCamera(*model.FindCamera(image.camera_id)),
        image.CamFromWorld(),
        context);
    if (cv::countNonZero(maps.depth) >= kMinPixels) {
      return;
    }
  }
  throw InputError(
      fmt::format("{}: none of the {} photographs shows {} pixels of the mesh "
                  "or more; is it in the frame of the sparse model?",
                  mesh_path_.string(),
                  model.images.size(),
                  kMinPixels));
}

void DepthMapRenderer::RenderMesh(const Workspace& workspace,
                                  const std::vector<const SparseImage*>& images,
                                  const Context& context) {
  const IndexedMesh mesh = ReadMeshAndLog(mesh_path_, context).mesh;
  if (mesh.triangles.empty()) {
    throw InputError(fmt::format("{}: the mesh has no faces, only {} vertices",
                                 mesh_path_.string(),
                                 mesh.positions.size()));
  }
  const RayScene rays(mesh);
  CheckIsSeen(mesh, rays, workspace.model, context);
  WriteOrigin(workspace.model);
  Phase phase(context, "depth maps of the mesh", images.size());
  for (const SparseImage* image : images) {
    const PinholeCamera camera =
        UndistortedCamera(*workspace.model.FindCamera(image->camera_id));
    Write(*image,
          RenderDepthAndNormals(
              mesh, rays, camera, image->CamFromWorld(), context));
    phase.Advance();
  }
}

// The view's depths at the pixels of the whole photograph.
cv::Mat WholeFrame(const cv::Mat& depth,
                   const PinholeCamera& from,
                   const PinholeCamera& to) {
  cv::Mat whole = cv::Mat::zeros(to.height, to.width, CV_32FC1);
  for (int y = 0; y < whole.rows; ++y) {
    for (int x = 0; x < whole.cols; ++x) {
      const Eigen::Vector2d pixel =
          from.Project(to.Unproject({x + 0.5, y + 0.5}));
      const double u = std::floor(pixel.x());
      const double v = std::floor(pixel.y());
      if (u >= 0 && v >= 0 && u < depth.cols && v < depth.rows) {
        whole.at<float>(y, x) = depth.at<float>(int(v), int(u));
      }
    }
  }
  return whole;
}

void DepthMapRenderer::Sweep(const Workspace& workspace,
                             const std::vector<const SparseImage*>& images,
                             const Context& context) {
  loading_.region.bounding_box = OptionalBoundingBox(bounding_box_);
  // A sample of the sweep is half a voxel: the images need be no finer.
  const LoadedScene loaded =
      LoadScene(workspace_path_, loading_, sweep_.level + 1, context);
  const std::vector<cv::Mat> depths = SweepDenseDepths(
      loaded.scene, loaded.region.cube, loaded.region.box, sweep_, context);
  WriteOrigin(workspace.model);
  Phase phase(context, "depth maps of the sweep", images.size());
  for (const SparseImage* image : images) {
    const PinholeCamera camera =
        UndistortedCamera(*workspace.model.FindCamera(image->camera_id));
    cv::Mat whole = cv::Mat::zeros(camera.height, camera.width, CV_32FC1);
    for (size_t i = 0; i < depths.size(); ++i) {
      if (loaded.scene.views[i].name == image->name) {
        whole = WholeFrame(depths[i], loaded.scene.views[i].camera, camera);
      }
    }
    Write(*image, FitNormals(whole, camera, kPlaneRadius, context));
    phase.Advance();
  }
}

void CheckUndistorted(const Workspace& workspace) {
  for (const char* folder : {"depth_maps", "normal_maps"}) {
    const fs::path path = workspace.path / "stereo" / folder;
    if (!fs::is_directory(path)) {
      throw InputError(fmt::format(
          "{}: no such folder; workspace_path must be an undistorted workspace "
          "as colmap image_undistorter makes it",
          path.string()));
    }
  }
  for (const SparseCamera& camera : workspace.model.cameras) {
    if (!IsPinhole(camera)) {
      throw InputError(fmt::format(
          "{}: camera {} has lens distortion; workspace_path must be an "
          "undistorted workspace as colmap image_undistorter makes it",
          workspace.model_path.string(),
          camera.id));
    }
  }
}

void DepthMapRenderer::Run(const CommandEnvironment& environment) {
  const Context& context = environment.context;
  sweep_.Check();
  const bool is_mesh = source_ == DepthSource::kMesh;
  CheckOption(is_mesh != mesh_path_.empty(),
              "mesh_path",
              mesh_path_.string(),
              is_mesh ? "must name a mesh for source = mesh"
                      : "must be empty for source = sweep, which knows of no "
                        "mesh");
  if (is_mesh) {
    environment.options.RefuseUnused({"image_path",
                                      "mask_path",
                                      "mask_geometry",
                                      "original_path",
                                      "skip_missing_masks",
                                      "skip_missing_images",
                                      "keep_all_views",
                                      "OctahedralMeshing.bounding_box",
                                      "sweep_level"},
                                     "source sweep");
  }
  WorkspaceOptions options = loading_.workspace;
  options.needs_masks = !is_mesh;
  options.needs_images = !is_mesh;
  const Workspace workspace = OpenWorkspace(workspace_path_, options, context);
  CheckUndistorted(workspace);
  const std::vector<const SparseImage*> images = WantedImages(workspace.model);
  const size_t num_kept = workspace.model.images.size() - images.size();
  if (is_mesh) {
    RenderMesh(workspace, images, context);
  } else if (!images.empty()) {
    Sweep(workspace, images, context);
  }
  environment.out << fmt::format(
      "{}: {} depth maps and normal maps written with {} depths, {} kept\n",
      (workspace.path / "stereo").string(),
      num_written_,
      num_depths_,
      num_kept);
}

}  // namespace

std::unique_ptr<Command> MakeDepthMapRenderer() {
  return std::make_unique<DepthMapRenderer>();
}

}  // namespace octacut
