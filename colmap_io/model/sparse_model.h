// A COLMAP sparse model: cameras, posed images with their observations, and
// points. What structure from motion hands to octacut.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <string>
#include <vector>

#include "colmap_io/model/camera_models.h"
#include "core/scene/camera.h"

namespace octacut {

// A keypoint of an image. Laid out as in images.bin.
struct SparseObservation {
  static constexpr uint64_t kNoPoint = std::numeric_limits<uint64_t>::max();

  double x = 0;  // pixels, of the image as the model's camera has it
  double y = 0;
  uint64_t point3D_id = kNoPoint;

  bool HasPoint() const { return point3D_id != kNoPoint; }
};

struct SparseImage {
  uint32_t id = 0;
  uint32_t camera_id = 0;
  std::string name;  // relative to the folder of images; UTF-8, may hold '/'

  // Camera from world; the rotation is of unit length.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  std::vector<SparseObservation> observations;

  Rigid3d CamFromWorld() const {
    return {rotation.toRotationMatrix(), translation};
  }
};

// Which observation of which image sees a point. Laid out as in points3D.bin.
struct TrackElement {
  uint32_t image_id = 0;
  uint32_t point2D_index = 0;  // position in SparseImage::observations
};

struct SparsePoint {
  uint64_t id = 0;
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();  // world
  std::array<uint8_t, 3> rgb = {0, 0, 0};
  double error = -1;  // mean reprojection error in pixels; negative or NaN
                      // where it is not known
  std::vector<TrackElement> track;
};

struct SparseModel {
  std::vector<SparseCamera> cameras;
  // In the order of the file: other files of COLMAP (fused.ply.vis) name
  // images by their position.
  std::vector<SparseImage> images;
  std::vector<SparsePoint> points;

  // The camera of that id or null; linear in the number of cameras.
  const SparseCamera* FindCamera(uint32_t id) const;
};

// What messages call the parts of a model.
struct SparseModelNames {
  std::string cameras = "cameras";
  std::string images = "images";
  std::string points = "points3D";
};

// Throws InputError unless the model is consistent: cameras as CheckCamera
// demands, no id twice, poses finite with unit quaternions, names not empty,
// every image's camera, every observation's point and every track's image and
// observation there. Readers and writers call it.
void CheckSparseModel(const SparseModel& model,
                      const SparseModelNames& names = {});

}  // namespace octacut
