#include "core/texture/view_costs.h"

#include <algorithm>
#include <cmath>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <opencv2/core/mat.hpp>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kFacesAtOnce = 4096;
// Triangles that vote on the exposure of a view are at most about so many.
constexpr size_t kExposureSamples = 20000;
constexpr int kExposureRounds = 4;
// Logarithm of the ratio of two colours of one triangle beyond which a pair
// counts less: noise and gloss.
constexpr double kUsualRatio = 0.1;
// Grey levels by which colours of one surface differ between photographs from
// noise, compression and sampling alone.
constexpr float kColorNoise = 4;
// Colours more than this many deviations from the median are not confirmed.
constexpr float kOutlier = 3;
// Darker and brighter values say nothing about exposure.
constexpr float kDarkest = 16;
constexpr float kBrightest = 240;
// Blur is judged in tiles of so many pixels, so that noise averages out. It may
// come from depth of field, which varies over a photograph.
constexpr int kTile = 64;
// A view of less than this sharpness is as bad as any.
constexpr float kMinSharpness = 0.05f;

using FaceColor = Eigen::Vector3f;

float MedianOf(std::array<float, FaceViews::kMaxViews>& values, size_t count) {
  const size_t middle = count / 2;
  std::nth_element(
      values.begin(), values.begin() + middle, values.begin() + count);
  const float upper = values[middle];
  if (count % 2 == 1) {
    return upper;
  }
  return (upper + *std::max_element(values.begin(), values.begin() + middle)) /
         2;
}

FaceColor MedianColor(std::span<const FaceView> views,
                      const std::vector<FaceColor>& gains) {
  FaceColor median = FaceColor::Zero();
  std::array<float, FaceViews::kMaxViews> values;
  for (int c = 0; c < 3 && !views.empty(); ++c) {
    for (size_t i = 0; i < views.size(); ++i) {
      values[i] = float(views[i].color[c]) / gains[views[i].view][c];
    }
    median[c] = MedianOf(values, views.size());
  }
  return median;
}

// Exposures of the views, whose geometric mean is one: least squares over the
// logarithms of the colours that pairs of views have of one triangle. Pairs
// that other causes make differ are weighted down.
class ExposureSolver {
 public:
  ExposureSolver(const FaceViews& views, size_t num_views)
      : views_(views),
        step_(1 + views.NumFaces() / kExposureSamples),
        logs_(Eigen::MatrixX3d::Zero(Eigen::Index(num_views), 3)) {}

  std::vector<FaceColor> Run() {
    for (int round = 0; round < kExposureRounds; ++round) {
      Solve();
    }
    const Eigen::RowVector3d mean = logs_.colwise().mean();
    std::vector<FaceColor> gains(size_t(logs_.rows()));
    for (Eigen::Index v = 0; v < logs_.rows(); ++v) {
      gains[size_t(v)] =
          (logs_.row(v) - mean).array().exp().transpose().cast<float>();
    }
    return gains;
  }

 private:
  void Solve() {
    triplets_.clear();
    right_ = Eigen::MatrixX3d::Zero(logs_.rows(), 3);
    // Keeps views that share no triangle with others at one.
    for (Eigen::Index v = 0; v < logs_.rows(); ++v) {
      triplets_.emplace_back(int(v), int(v), 1e-3);
    }
    for (size_t f = 0; f < views_.NumFaces(); f += step_) {
      const std::span<const FaceView> candidates = views_.Of(f);
      for (size_t i = 0; i < candidates.size(); ++i) {
        for (size_t j = i + 1; j < candidates.size(); ++j) {
          AddPair(candidates[i], candidates[j]);
        }
      }
    }
    Eigen::SparseMatrix<double> matrix(logs_.rows(), logs_.rows());
    matrix.setFromTriplets(triplets_.begin(), triplets_.end());
    logs_ = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(
        right_);
  }

  void AddPair(const FaceView& a, const FaceView& b) {
    Eigen::RowVector3d difference;
    for (int c = 0; c < 3; ++c) {
      const float x = float(a.color[size_t(c)]);
      const float y = float(b.color[size_t(c)]);
      if (std::min(x, y) <= kDarkest || std::max(x, y) >= kBrightest) {
        return;
      }
      difference[c] = double(std::log(x / y));
    }
    const Eigen::RowVector3d rest =
        difference - (logs_.row(a.view) - logs_.row(b.view));
    const double weight =
        1 / (1 + rest.squaredNorm() / (kUsualRatio * kUsualRatio));
    triplets_.emplace_back(a.view, a.view, weight);
    triplets_.emplace_back(b.view, b.view, weight);
    triplets_.emplace_back(a.view, b.view, -weight);
    triplets_.emplace_back(b.view, a.view, -weight);
    right_.row(a.view) += weight * difference;
    right_.row(b.view) -= weight * difference;
  }

  const FaceViews& views_;
  const size_t step_;
  Eigen::MatrixX3d logs_;
  Eigen::MatrixX3d right_;
  std::vector<Eigen::Triplet<double>> triplets_;
};

// Contrast of each tile of each view over that of the same triangles in other
// views, at most 1.
class Sharpness {
 public:
  Sharpness(const IndexedMesh& mesh,
            const FaceViews& views,
            const std::vector<PhotographPose>& poses)
      : mesh_(mesh), poses_(poses) {
    std::vector<cv::Mat> own(poses.size());
    std::vector<cv::Mat> usual(poses.size());
    for (size_t v = 0; v < poses.size(); ++v) {
      const cv::Size size(poses[v].camera.width / kTile + 1,
                          poses[v].camera.height / kTile + 1);
      own[v] = cv::Mat(size, CV_64F, cv::Scalar(0));
      usual[v] = cv::Mat(size, CV_64F, cv::Scalar(0));
    }
    for (size_t f = 0; f < views.NumFaces(); ++f) {
      const std::span<const FaceView> candidates = views.Of(f);
      if (candidates.size() < 3) {
        continue;
      }
      std::array<float, FaceViews::kMaxViews> contrasts;
      for (size_t i = 0; i < candidates.size(); ++i) {
        contrasts[i] = candidates[i].contrast;
      }
      const float median = MedianOf(contrasts, candidates.size());
      for (const FaceView& view : candidates) {
        const cv::Point tile = TileOf(f, view.view);
        own[view.view].at<double>(tile) += view.contrast;
        usual[view.view].at<double>(tile) += median;
      }
    }
    for (size_t v = 0; v < poses.size(); ++v) {
      tiles_.emplace_back(own[v].size(), CV_32F, cv::Scalar(1));
      for (int y = 0; y < own[v].rows; ++y) {
        for (int x = 0; x < own[v].cols; ++x) {
          const double there = usual[v].at<double>(y, x);
          if (there > 0) {
            tiles_[v].at<float>(y, x) = std::clamp(
                float(own[v].at<double>(y, x) / there), kMinSharpness, 1.0f);
          }
        }
      }
    }
  }

  float Of(size_t face, size_t view) const {
    return tiles_[view].at<float>(TileOf(face, view));
  }

 private:
  cv::Point TileOf(size_t face, size_t view) const {
    const auto& corners = mesh_.triangles[face];
    const Eigen::Vector3d center =
        (mesh_.positions[corners[0]] + mesh_.positions[corners[1]] +
         mesh_.positions[corners[2]]) /
        3;
    const PhotographPose& pose = poses_[view];
    const Eigen::Vector2d pixel =
        pose.camera.Project(pose.cam_from_world * center);
    return {std::clamp(int(pixel.x()) / kTile, 0, pose.camera.width / kTile),
            std::clamp(int(pixel.y()) / kTile, 0, pose.camera.height / kTile)};
  }

  const IndexedMesh& mesh_;
  const std::vector<PhotographPose>& poses_;
  std::vector<cv::Mat> tiles_;
};

// 0 for a colour that the others confirm to 1 for one that they do not.
void RateColors(std::span<const FaceView> views,
                const std::vector<FaceColor>& gains,
                const FaceColor& consensus,
                std::array<float, FaceViews::kMaxViews>* costs) {
  costs->fill(0);
  // Two cannot outvote one another.
  if (views.size() < 3) {
    return;
  }
  std::array<float, FaceViews::kMaxViews> differences;
  for (size_t i = 0; i < views.size(); ++i) {
    differences[i] =
        (views[i].Color().cwiseQuotient(gains[views[i].view]) - consensus)
            .cwiseAbs()
            .maxCoeff();
  }
  auto sorted = differences;
  // The median of absolute differences is 0.67 standard deviations.
  const float deviation =
      std::max(kColorNoise, 1.5f * MedianOf(sorted, views.size()));
  for (size_t i = 0; i < views.size(); ++i) {
    const float relative = differences[i] / (kOutlier * deviation);
    (*costs)[i] = std::min(1.0f, relative * relative);
  }
}

}  // namespace

ViewCosts ComputeViewCosts(const IndexedMesh& mesh,
                           const FaceViews& views,
                           const std::vector<PhotographPose>& poses,
                           const Context& context) {
  ViewCosts result;
  result.gains = ExposureSolver(views, poses.size()).Run();
  const Sharpness sharpness(mesh, views, poses);
  const size_t num_faces = views.NumFaces();
  result.consensus.resize(num_faces);
  result.costs.resize(num_faces);
  result.resolution.assign(num_faces, 0);
  ParallelEach(context, num_faces, kFacesAtOnce, [&](size_t f) {
    const std::span<const FaceView> candidates = views.Of(f);
    result.consensus[f] = MedianColor(candidates, result.gains);
    RateColors(candidates, result.gains, result.consensus[f], &result.costs[f]);
    std::array<float, FaceViews::kMaxViews> resolutions;
    for (size_t i = 0; i < candidates.size(); ++i) {
      resolutions[i] =
          candidates[i].resolution * sharpness.Of(f, candidates[i].view);
      result.resolution[f] = std::max(result.resolution[f], resolutions[i]);
    }
    for (size_t i = 0; i < candidates.size(); ++i) {
      result.costs[f][i] += 1 - resolutions[i] / result.resolution[f];
    }
  });
  return result;
}

}  // namespace octacut
