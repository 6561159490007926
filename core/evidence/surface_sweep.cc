#include "core/evidence/surface_sweep.h"

#include <algorithm>
#include <limits>

#include "core/evidence/depth_confidence.h"
#include "core/evidence/pick_depths.h"
#include "core/evidence/score_volume.h"

namespace octacut {
namespace {

// The range of depths, voxels: before the present surface, as far as its crust
// reached, and behind it: the floors of folds twice as deep as two windows of
// the first sweep are wide.
constexpr float kBefore = 3;
constexpr float kBehind = 20;
// Between planes, voxels: neighbours at 15 degrees move by 0.8 samples.
constexpr float kSpacing = 1.5f;
// A peak within so many planes of an end of the range may belong to one beyond.
constexpr float kEndPlanes = 0.75f;
// Side of the squares, samples.
constexpr int kSide = 32;
// Samples between those that tell where a square's surface is.
constexpr int kStep = 8;
// Side of the blocks of space, voxels: two squares, so that much of what they
// show is found in neighbouring views as well. One of kSampleShare, a power of
// two, is in the sample, scattered evenly.
constexpr float kBlock = 32;
constexpr int kSampleShare = 8;
// Depth of rays that are part of windows alone.
constexpr float kNoDepth = 1e-12f;

// What a part of a view shows.
ViewProjection Cropped(const ViewProjection& projection, float u, float v) {
  ViewProjection cropped = projection;
  cropped.linear.row(0) -= u * projection.linear.row(2);
  cropped.linear.row(1) -= v * projection.linear.row(2);
  cropped.offset.x() -= u * projection.offset.z();
  cropped.offset.y() -= v * projection.offset.z();
  return cropped;
}

}  // namespace

// Samples [x0, x1) x [y0, y1).
struct SurfaceSweep::Square {
  Square(const SweepView& view, int x, int y)
      : x0(x),
        y0(y),
        x1(std::min(view.grey.cols, x + kSide)),
        y1(std::min(view.grey.rows, y + kSide)) {}
  int x0, y0, x1, y1;
};

SurfaceSweep::SurfaceSweep(const std::vector<SweepView>& views,
                           const VoxelValues& depth_confidence,
                           int level,
                           const DepthSweepOptions& options)
    : views_(views),
      depth_confidence_(depth_confidence),
      voxel_(1.0f / float(1 << level)),
      options_(options) {}

SweptDepthMap SurfaceSweep::EmptyMap(int view) const {
  SweptDepthMap map;
  map.width = views_[view].grey.cols;
  map.height = views_[view].grey.rows;
  map.scale = views_[view].scale;
  map.depths.assign(size_t(map.width) * map.height, 0);
  return map;
}

void SurfaceSweep::AddDepths(int view,
                             const std::vector<int>& neighbors,
                             bool of_sample,
                             SweptDepthMap* map) const {
  if (neighbors.size() < 2) {
    return;  // one alone cannot tell an occlusion from a mismatch
  }
  std::vector<SweepView> compared(1);  // the first is for the square
  std::vector<int> others;
  for (const int j : neighbors) {
    others.push_back(int(compared.size()));
    compared.push_back(views_[j]);
  }
  for (int y = 0; y < map->height; y += kSide) {
    for (int x = 0; x < map->width; x += kSide) {
      const Square square(views_[view], x, y);
      if (IsWanted(views_[view], square, of_sample)) {
        SweepSquare(views_[view], square, others, &compared, map);
      }
    }
  }
}

bool SurfaceSweep::IsWanted(const SweepView& view,
                            const Square& square,
                            bool of_sample) const {
  const Eigen::Matrix3f rays = view.projection->RaysOfPixels();
  int balance = 0;
  int sample_balance = 0;
  for (int y = square.y0; y < square.y1; y += kStep) {
    for (int x = square.x0; x < square.x1; x += kStep) {
      if (!(view.far_depth(y, x) > 0)) {
        continue;
      }
      const Eigen::Vector3f pixel(
          (float(x) + 0.5f) / view.scale, (float(y) + 0.5f) / view.scale, 1);
      // The near depth is that of the nearest cut voxel, less a voxel.
      const Eigen::Vector3f point =
          view.projection->center +
          (view.near_depth(y, x) + voxel_) * (rays * pixel);
      balance += depth_confidence_.AtPoint(point, 1) >= kRatherRight ? 1 : -1;
      const Eigen::Vector3i block =
          (point / (kBlock * voxel_)).array().floor().cast<int>();
      sample_balance +=
          (block.dot(Eigen::Vector3i(1, 2, 5)) & (kSampleShare - 1)) == 0 ? 1
                                                                          : -1;
    }
  }
  return balance > 0 && (sample_balance > 0) == of_sample;
}

void SurfaceSweep::SweepSquare(const SweepView& view,
                               const Square& square,
                               const std::vector<int>& others,
                               std::vector<SweepView>* compared,
                               SweptDepthMap* map) const {
  const int radius = DepthSweepOptions::kWindowRadius;
  const int left = std::max(0, square.x0 - radius);
  const int top = std::max(0, square.y0 - radius);
  const cv::Rect part(left,
                      top,
                      std::min(view.grey.cols, square.x1 + radius) - left,
                      std::min(view.grey.rows, square.y1 + radius) - top);
  const ViewProjection projection = Cropped(
      *view.projection, float(left) / view.scale, float(top) / view.scale);
  SweepView& crop = (*compared)[0];
  crop.projection = &projection;
  crop.scale = view.scale;
  crop.grey = view.grey(part);
  crop.near_depth.create(part.height, part.width);
  crop.far_depth.create(part.height, part.width);
  crop.near_depth.setTo(std::numeric_limits<float>::infinity());
  crop.far_depth.setTo(kNoDepth);
  for (int y = square.y0; y < square.y1; ++y) {
    for (int x = square.x0; x < square.x1; ++x) {
      const float far = view.far_depth(y, x);
      if (far > 0) {
        const float surface = view.near_depth(y, x) + voxel_;
        crop.near_depth(y - top, x - left) =
            std::max(surface - kBefore * voxel_, 0.5f * surface);
        crop.far_depth(y - top, x - left) =
            std::min(surface + kBehind * voxel_, far);
      }
    }
  }
  const ScoreVolume volume =
      ScorePlanes(*compared, 0, others, kSpacing * voxel_, options_, true);
  const SweptDepthMap depths =
      PickDepths(crop, volume, float(DepthSweepOptions::kMinScore));
  const float margin = kEndPlanes * volume.spacing;
  for (int y = square.y0; y < square.y1; ++y) {
    for (int x = square.x0; x < square.x1; ++x) {
      const float depth =
          depths.depths[size_t(y - top) * part.width + (x - left)];
      if (depth > crop.near_depth(y - top, x - left) + margin &&
          depth < crop.far_depth(y - top, x - left) - margin) {
        map->depths[size_t(y) * map->width + x] = depth;
      }
    }
  }
}

}  // namespace octacut
