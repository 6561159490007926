#include "colmap_io/images/marker_sightings.h"

#include <fmt/format.h>

#include "colmap_io/images/image_file.h"
#include "colmap_io/model/camera_projector.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

std::vector<MarkerSighting> SightingsIn(const Workspace& workspace,
                                        const SparseImage& image,
                                        MarkerDictionary dictionary) {
  const auto path = workspace.image_path / image.name;
  const SparseCamera& camera = *workspace.model.FindCamera(image.camera_id);
  const cv::Mat photograph = ReadPhotograph(path);
  if (uint64_t(photograph.cols) != uint64_t(camera.width) ||
      uint64_t(photograph.rows) != uint64_t(camera.height)) {
    throw InputError(fmt::format(
        "{}: the image has {}x{} pixels, but its camera {} has {}x{}",
        path.string(),
        photograph.cols,
        photograph.rows,
        camera.id,
        camera.width,
        camera.height));
  }
  const CameraProjector projector(camera);
  std::vector<MarkerSighting> sightings;
  for (const DetectedMarker& marker : DetectMarkers(photograph, dictionary)) {
    MarkerSighting sighting;
    sighting.id = marker.id;
    sighting.cam_from_world = image.CamFromWorld();
    sighting.focal_length =
        (projector.Intrinsics().fx + projector.Intrinsics().fy) / 2;
    bool has_rays = true;
    for (int corner = 0; corner < 4; ++corner) {
      const auto ray = projector.CamFromImg(marker.corners[corner]);
      has_rays = has_rays && ray.has_value();
      sighting.rays[corner] = ray.value_or(Eigen::Vector3d::UnitZ());
    }
    if (has_rays) {
      sightings.push_back(sighting);
    }
  }
  return sightings;
}

}  // namespace

std::vector<MarkerSighting> FindMarkerSightings(const Workspace& workspace,
                                                MarkerDictionary dictionary,
                                                const Context& context) {
  const auto& images = workspace.model.images;
  std::vector<std::vector<MarkerSighting>> found(images.size());
  Phase phase(context, "ArUco markers", images.size());
  ParallelFor(context, images.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      found[i] = SightingsIn(workspace, images[i], dictionary);
      phase.Advance();
    }
  });
  std::vector<MarkerSighting> sightings;
  for (const auto& part : found) {
    sightings.insert(sightings.end(), part.begin(), part.end());
  }
  return sightings;
}

}  // namespace octacut
