#include "colmap_io/model/sparse_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <unordered_map>

#include "core/base/error.h"

namespace octacut {
namespace {

// Of cameras from the origin: squares and products of such lengths are floats.
constexpr double kMaxDistance = 1e15;

// Id -> position, for the checks.
template <typename Id, typename Item>
std::unordered_map<Id, size_t> IndexById(const std::vector<Item>& items,
                                         const std::string& source,
                                         const char* what) {
  std::unordered_map<Id, size_t> index;
  index.reserve(items.size());
  for (size_t i = 0; i < items.size(); ++i) {
    if (!index.emplace(items[i].id, i).second) {
      throw InputError(
          fmt::format("{}: {} id {} occurs twice", source, what, items[i].id));
    }
  }
  return index;
}

// Commands write files of the images' names into folders of their own.
bool LeavesItsFolder(const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() ||
         std::find(path.begin(), path.end(), "..") != path.end();
}

void CheckImage(const SparseImage& image,
                const std::unordered_map<uint32_t, size_t>& cameras,
                const SparseModelNames& names) {
  const auto fail = [&](const std::string& message) {
    throw InputError(fmt::format(
        "{}: image {} ({}): {}", names.images, image.id, image.name, message));
  };
  if (image.name.empty()) fail("its name is empty");
  if (LeavesItsFolder(image.name)) {
    fail("its name must be a path below the folder of the images, without ..");
  }
  if (!cameras.contains(image.camera_id)) {
    fail(fmt::format("camera_id = {}: {} has no such camera",
                     image.camera_id,
                     names.cameras));
  }
  const double norm = image.rotation.coeffs().norm();
  if (!(std::abs(norm - 1) < 1e-6)) {
    fail(fmt::format("quaternion of length {}: must be 1", norm));
  }
  if (!image.translation.allFinite()) fail("its translation is not finite");
  if (image.translation.norm() > kMaxDistance) {
    fail(fmt::format("translation of length {:g}: must be at most {:g}",
                     image.translation.norm(),
                     kMaxDistance));
  }
}

void CheckNamesDiffer(const SparseModel& model, const SparseModelNames& names) {
  std::unordered_map<std::string, uint32_t> id_of;
  for (const SparseImage& image : model.images) {
    const auto [other, is_new] = id_of.emplace(image.name, image.id);
    if (!is_new) {
      throw InputError(fmt::format("{}: images {} and {} have the same name {}",
                                   names.images,
                                   other->second,
                                   image.id,
                                   image.name));
    }
  }
}

void CheckObservations(const SparseImage& image,
                       const std::unordered_map<uint64_t, size_t>& points,
                       const SparseModelNames& names) {
  for (size_t i = 0; i < image.observations.size(); ++i) {
    const SparseObservation& observation = image.observations[i];
    if (observation.HasPoint() && !points.contains(observation.point3D_id)) {
      throw InputError(fmt::format(
          "{}: image {} ({}): observation {} has point3D_id = {}: {} has no "
          "such point",
          names.images,
          image.id,
          image.name,
          i,
          observation.point3D_id,
          names.points));
    }
  }
}

void CheckPoint(const SparsePoint& point,
                const SparseModel& model,
                const std::unordered_map<uint32_t, size_t>& images,
                const SparseModelNames& names) {
  const auto fail = [&](const std::string& message) {
    throw InputError(
        fmt::format("{}: point {}: {}", names.points, point.id, message));
  };
  if (!point.xyz.allFinite()) fail("its coordinates are not finite");
  if (point.id == SparseObservation::kNoPoint)
    fail("this id is reserved for observations without a point");
  for (const TrackElement& element : point.track) {
    const auto image = images.find(element.image_id);
    if (image == images.end()) {
      fail(fmt::format("track has image_id = {}: {} has no such image",
                       element.image_id,
                       names.images));
    }
    const size_t count = model.images[image->second].observations.size();
    if (element.point2D_index >= count) {
      fail(fmt::format(
          "track has point2D_idx = {} of image {}, which has {} observations",
          element.point2D_index,
          element.image_id,
          count));
    }
  }
}

}  // namespace

const SparseCamera* SparseModel::FindCamera(uint32_t id) const {
  for (const SparseCamera& camera : cameras) {
    if (camera.id == id) return &camera;
  }
  return nullptr;
}

void CheckSparseModel(const SparseModel& model, const SparseModelNames& names) {
  for (const SparseCamera& camera : model.cameras) {
    CheckCamera(camera, names.cameras);
  }
  const auto cameras =
      IndexById<uint32_t>(model.cameras, names.cameras, "camera");
  const auto images = IndexById<uint32_t>(model.images, names.images, "image");
  const auto points = IndexById<uint64_t>(model.points, names.points, "point");
  for (const SparseImage& image : model.images) {
    CheckImage(image, cameras, names);
    CheckObservations(image, points, names);
  }
  CheckNamesDiffer(model, names);
  for (const SparsePoint& point : model.points) {
    CheckPoint(point, model, images, names);
  }
}

}  // namespace octacut
