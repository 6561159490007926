#include "core/benchmark/compare/shared_cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/SVD>

#include "core/base/error.h"
#include "core/base/median.h"

namespace octacut {
namespace {

constexpr size_t kMinCameras = 3;
constexpr int kMaxRounds = 20;
constexpr double kInlierMedians = 3;
// Centres whose squared deviations are within this share of their squared
// distance from the origin coincide.
constexpr double kCoincident = 1e-9;

struct CenterPair {
  Eigen::Vector3d model;
  Eigen::Vector3d reference;
};

// The rotation nearest to all those that single cameras give.
Eigen::Matrix3d MeanRotation(const std::vector<SharedCamera>& cameras,
                             const std::vector<bool>& counts) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (size_t i = 0; i < cameras.size(); ++i) {
    if (counts[i]) {
      sum += cameras[i].cam_from_reference.rotation.transpose() *
             cameras[i].cam_from_model.rotation;
    }
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d& u = svd.matrixU();
  const Eigen::Matrix3d& v = svd.matrixV();
  const Eigen::Vector3d signs(
      1, 1, (u * v.transpose()).determinant() < 0 ? -1 : 1);
  return u * signs.asDiagonal() * v.transpose();
}

CenterPair MeanOf(const std::vector<CenterPair>& centers,
                  const std::vector<bool>& counts) {
  CenterPair mean{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  double number = 0;
  for (size_t i = 0; i < centers.size(); ++i) {
    if (counts[i]) {
      mean.model += centers[i].model;
      mean.reference += centers[i].reference;
      ++number;
    }
  }
  return {mean.model / number, mean.reference / number};
}

// Least squares for scale and translation.
Similarity3d FitCenters(const std::vector<CenterPair>& centers,
                        const std::vector<bool>& counts,
                        const Eigen::Matrix3d& rotation) {
  const CenterPair mean = MeanOf(centers, counts);
  double along = 0;
  double model = 0;
  double reference = 0;
  for (size_t i = 0; i < centers.size(); ++i) {
    if (counts[i]) {
      const Eigen::Vector3d a = rotation * (centers[i].model - mean.model);
      const Eigen::Vector3d b = centers[i].reference - mean.reference;
      along += a.dot(b);
      model += a.squaredNorm();
      reference += b.squaredNorm();
    }
  }
  if (!(model > kCoincident * mean.model.squaredNorm()) ||
      !(reference > kCoincident * mean.reference.squaredNorm()) ||
      !(along > 0)) {
    throw InputError(
        "the cameras of the two models cannot be aligned: their centres "
        "coincide, or the models show different arrangements");
  }
  const double scale = along / model;
  return {scale, rotation, mean.reference - scale * (rotation * mean.model)};
}

// The spread of the reference's centres.
double SpreadOfCenters(const std::vector<CenterPair>& centers,
                       const std::vector<bool>& counts) {
  const CenterPair mean = MeanOf(centers, counts);
  double sum = 0;
  double number = 0;
  for (size_t i = 0; i < centers.size(); ++i) {
    if (counts[i]) {
      sum += (centers[i].reference - mean.reference).squaredNorm();
      ++number;
    }
  }
  return std::sqrt(sum / number);
}

std::vector<double> Residuals(const std::vector<CenterPair>& centers,
                              const Similarity3d& reference_from_model) {
  std::vector<double> residuals;
  residuals.reserve(centers.size());
  for (const CenterPair& pair : centers) {
    residuals.push_back(
        (reference_from_model * pair.model - pair.reference).norm());
  }
  return residuals;
}

}  // namespace

SharedCameraAlignment AlignSharedCameras(
    const std::vector<SharedCamera>& cameras) {
  if (cameras.size() < kMinCameras) {
    throw InputError(
        fmt::format("the two models share {} photographs; at least {} are "
                    "needed to align them",
                    cameras.size(),
                    kMinCameras));
  }
  std::vector<CenterPair> centers;
  centers.reserve(cameras.size());
  for (const SharedCamera& camera : cameras) {
    centers.push_back({camera.cam_from_model.Inverse().translation,
                       camera.cam_from_reference.Inverse().translation});
  }
  std::vector<bool> counts(cameras.size(), true);
  SharedCameraAlignment result;
  for (int round = 0; round < kMaxRounds; ++round) {
    result.reference_from_model =
        FitCenters(centers, counts, MeanRotation(cameras, counts));
    const std::vector<double> residuals =
        Residuals(centers, result.reference_from_model);
    const double limit = kInlierMedians * Median(residuals);
    std::vector<bool> inliers(cameras.size());
    double sum = 0;
    result.num_inliers = 0;
    for (size_t i = 0; i < cameras.size(); ++i) {
      inliers[i] = residuals[i] <= limit;
      sum += inliers[i] ? residuals[i] * residuals[i] : 0;
      result.num_inliers += inliers[i] ? 1 : 0;
    }
    result.rms = std::sqrt(sum / double(result.num_inliers));
    if (inliers == counts) {
      break;
    }
    counts = inliers;
  }
  result.spread = SpreadOfCenters(centers, counts);
  return result;
}

}  // namespace octacut
