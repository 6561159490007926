#include "plugin/example_workspace.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>

#include "colmap_io/files/create_folder.h"
#include "colmap_io/images/write_image.h"
#include "colmap_io/mesh/mesh_io.h"
#include "colmap_io/model/write_sparse_model.h"
#include "core/base/check_option.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

SparseCamera ToSparseCamera(const Lens& lens) {
  const PinholeCamera& camera = lens.camera;
  SparseCamera sparse;
  sparse.id = 1;
  sparse.width = uint64_t(camera.width);
  sparse.height = uint64_t(camera.height);
  if (lens.k1 == 0) {
    sparse.model_id = camera_model::kPinhole;
    sparse.params = {camera.fx, camera.fy, camera.cx, camera.cy};
  } else {
    // A Lens has its coefficient as this model has; its pixels are square.
    sparse.model_id = camera_model::kSimpleRadial;
    sparse.params = {camera.fx, camera.cx, camera.cy, lens.k1};
  }
  return sparse;
}

SparseImage ToSparseImage(const SyntheticView& view, uint32_t id) {
  SparseImage image;
  image.id = id;
  image.camera_id = 1;
  image.name = view.name;
  image.rotation = Eigen::Quaterniond(view.cam_from_world.rotation);
  image.rotation.normalize();
  image.translation = view.cam_from_world.translation;
  return image;
}

}  // namespace

void ExampleWorkspaceOptions::Check() const {
  CheckOption(jpeg_quality >= 1 && jpeg_quality <= 100,
              "jpeg_quality",
              jpeg_quality,
              "must be between 1 and 100");
}

SparseModel ToSparseModel(const SyntheticScene& scene) {
  SparseModel model;
  model.cameras.push_back(ToSparseCamera(scene.views.front().lens));
  for (const SyntheticView& view : scene.views) {
    model.images.push_back(
        ToSparseImage(view, uint32_t(model.images.size() + 1)));
  }
  for (const SyntheticPoint& source : scene.points) {
    SparsePoint point;
    point.id = model.points.size() + 1;
    point.xyz = source.position;
    point.rgb = source.color;
    point.error = 0;
    for (const auto& [view, pixel] : source.observations) {
      SparseImage& image = model.images[view];
      point.track.push_back({image.id, uint32_t(image.observations.size())});
      image.observations.push_back({pixel.x(), pixel.y(), point.id});
      const Eigen::Vector2d projected = scene.views[view].lens.Project(
          scene.views[view].cam_from_world * source.position);
      point.error +=
          (projected - pixel).norm() / double(source.observations.size());
    }
    model.points.push_back(std::move(point));
  }
  return model;
}

void CheckExampleFolder(const fs::path& folder,
                        const ExampleWorkspaceOptions& options) {
  options.Check();
  std::error_code ignored;
  if (fs::exists(folder) &&
      (!fs::is_directory(folder) || !fs::is_empty(folder, ignored))) {
    if (!fs::is_regular_file(folder / kExampleReportName)) {
      throw InputError(
          fmt::format("{}: exists and is not an example of octacut; choose "
                      "another --output_path",
                      folder.string()));
    }
    if (!options.overwrite) {
      throw InputError(fmt::format(
          "{}: the folder already holds an example; --overwrite 1 replaces it",
          folder.string()));
    }
  }
}

void PrepareExampleFolder(const fs::path& folder,
                          const ExampleWorkspaceOptions& options) {
  CheckExampleFolder(folder, options);
  for (const char* part : {"images", "masks", "background", "sparse/0", "gt"}) {
    fs::remove_all(folder / part);
  }
  CreateFolder(folder);
}

void WriteExampleWorkspace(const SyntheticScene& scene,
                           const fs::path& folder,
                           const ExampleWorkspaceOptions& options,
                           const Context& context) {
  options.Check();
  for (const char* part : {"images", "masks", "sparse", "gt"}) {
    CreateFolder(folder / part);
  }
  const Phase phase(context, "writing the workspace");
  ParallelEach(context, scene.views.size(), 1, [&](size_t i) {
    const SyntheticView& view = scene.views[i];
    WriteImage(folder / "images" / view.name,
               view.image,
               {cv::IMWRITE_JPEG_QUALITY, options.jpeg_quality});
    WriteImage(folder / "masks" / (view.name + ".png"), view.mask);
  });
  for (size_t i = 0; i < scene.empty_set.size(); ++i) {
    CreateFolder(folder / "background");
    WriteImage(folder / "background" /
                   fmt::format("empty_{:03}{}", i, scene.spec.image_extension),
               scene.empty_set[i],
               {cv::IMWRITE_JPEG_QUALITY, options.jpeg_quality});
  }
  WriteSparseModelBinary(ToSparseModel(scene), folder / "sparse" / "0");
  WriteMesh(folder / "gt" / "reference.ply", scene.reference);
}

}  // namespace octacut
