#include "colmap_io/images/marker_sightings.h"

#include "colmap_io/images/for_each_file.h"
#include "colmap_io/images/image_file.h"
#include "colmap_io/images/most_pixels.h"
#include "colmap_io/images/view_files.h"
#include "colmap_io/model/camera_projector.h"

namespace octacut {
namespace {

// Colours, grey values and thresholds of several windows.
constexpr size_t kBytesPerPixel = 8;

std::vector<MarkerSighting> SightingsIn(const Workspace& workspace,
                                        const SparseImage& image,
                                        MarkerDictionary dictionary) {
  const auto path = workspace.image_path / image.name;
  const SparseCamera& camera = *workspace.model.FindCamera(image.camera_id);
  const cv::Mat photograph = ReadPhotograph(path);
  RequireSizeOfCamera(path, photograph, camera);
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
  const size_t most_pixels =
      MostPixels(workspace.model.cameras,
                 [](const SparseCamera& camera) { return &camera; });
  ForEachFile(
      {.count = images.size(), .bytes_per_file = kBytesPerPixel * most_pixels},
      "ArUco markers",
      context,
      [&](size_t i) {
        found[i] = SightingsIn(workspace, images[i], dictionary);
      });
  std::vector<MarkerSighting> sightings;
  for (const auto& part : found) {
    sightings.insert(sightings.end(), part.begin(), part.end());
  }
  return sightings;
}

}  // namespace octacut
