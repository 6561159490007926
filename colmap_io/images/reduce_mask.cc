#include "colmap_io/images/reduce_mask.h"

#include <algorithm>
#include <cmath>

#include "colmap_io/images/undistorted_camera.h"
#include "colmap_io/model/camera_projector.h"
#include "core/scene/scene.h"

namespace octacut {
namespace {

// Pixels (x, y) of the result hold any object of pixels [k x, k x + k) etc.,
// with `padding` background pixels around.
cv::Mat ReduceBlocks(const cv::Mat& mask, int k, int padding) {
  cv::Mat blocks = cv::Mat::zeros((mask.rows + k - 1) / k + 2 * padding,
                                  (mask.cols + k - 1) / k + 2 * padding,
                                  CV_8UC1);
  for (int y = 0; y < mask.rows; ++y) {
    const uint8_t* row = mask.ptr<uint8_t>(y);
    uint8_t* out = blocks.ptr<uint8_t>(y / k + padding) + padding;
    for (int x = 0; x < mask.cols; x += k) {
      const uint8_t* end = row + std::min(x + k, mask.cols);
      if (*std::max_element(row + x, end) >= kObjectThreshold) {
        out[x / k] = 255;
      }
    }
  }
  return blocks;
}

bool TouchesBorder(const cv::Mat& mask) {
  for (int x = 0; x < mask.cols; ++x) {
    if (mask.at<uint8_t>(0, x) >= kObjectThreshold ||
        mask.at<uint8_t>(mask.rows - 1, x) >= kObjectThreshold) {
      return true;
    }
  }
  for (int y = 0; y < mask.rows; ++y) {
    if (mask.at<uint8_t>(y, 0) >= kObjectThreshold ||
        mask.at<uint8_t>(y, mask.cols - 1) >= kObjectThreshold) {
      return true;
    }
  }
  return false;
}

// Is there object among the block and its eight neighbours?
bool ObjectAround(const cv::Mat& blocks, int x, int y) {
  for (int j = std::max(0, y - 1); j <= std::min(blocks.rows - 1, y + 1); ++j) {
    const uint8_t* row = blocks.ptr<uint8_t>(j);
    for (int i = std::max(0, x - 1); i <= std::min(blocks.cols - 1, x + 1);
         ++i) {
      if (row[i] != 0) {
        return true;
      }
    }
  }
  return false;
}

// Bounding box of the tangents of the object; not complete when a part of it
// lies beyond kMaxTangent. Only the blocks on the object's outline can be
// extreme.
Frame FrameOfObject(const cv::Mat& blocks,
                    int k,
                    const CameraProjector& projector) {
  Frame frame;
  for (int y = 0; y < blocks.rows; ++y) {
    const uint8_t* row = blocks.ptr<uint8_t>(y);
    for (int x = 0; x < blocks.cols; ++x) {
      if (row[x] == 0 ||
          (x > 0 && y > 0 && x + 1 < blocks.cols && y + 1 < blocks.rows &&
           row[x - 1] && row[x + 1] && blocks.at<uint8_t>(y - 1, x) &&
           blocks.at<uint8_t>(y + 1, x))) {
        continue;
      }
      for (int corner = 0; corner < 4; ++corner) {
        const auto ray = projector.CamFromImg(
            {double(k) * (x + (corner & 1)), double(k) * (y + (corner >> 1))});
        if (!ray || !(ray->z() > 0)) {
          return {{}, false};
        }
        const Eigen::Vector2d tangents(ray->x() / ray->z(),
                                       ray->y() / ray->z());
        if (!(tangents.cwiseAbs().maxCoeff() < kMaxTangent)) {
          return {{}, false};
        }
        frame.tangents.extend(tangents);
      }
    }
  }
  return frame;
}

PinholeCamera CameraOfTangents(const Eigen::AlignedBox2d& tangents,
                               double fx,
                               double fy,
                               int border) {
  PinholeCamera camera;
  camera.fx = fx;
  camera.fy = fy;
  camera.cx = -tangents.min().x() * fx + border;
  camera.cy = -tangents.min().y() * fy + border;
  camera.width = int(std::ceil(tangents.sizes().x() * fx)) + 2 * border;
  camera.height = int(std::ceil(tangents.sizes().y() * fy)) + 2 * border;
  return camera;
}

// Every pixel is object when there is object near to its centre in the blocks,
// which are no smaller than it; `unknown` where there is no block.
cv::Mat WarpBlocks(const cv::Mat& blocks,
                   int k,
                   const CameraProjector& projector,
                   const PinholeCamera& target,
                   uint8_t unknown) {
  cv::Mat result(target.height, target.width, CV_8UC1);
  std::vector<float> map_x(target.width);
  std::vector<float> map_y(target.width);
  for (int y = 0; y < target.height; ++y) {
    projector.ImgFromCamRow(target.Unproject({0.5, y + 0.5}),
                            {1 / target.fx, 0, 0},
                            map_x.size(),
                            map_x.data(),
                            map_y.data());
    uint8_t* row = result.ptr<uint8_t>(y);
    for (int x = 0; x < target.width; ++x) {
      const int block_x = int(std::floor(map_x[x] / float(k)));
      const int block_y = int(std::floor(map_y[x] / float(k)));
      const bool there = block_x >= 0 && block_y >= 0 &&
                         block_x < blocks.cols && block_y < blocks.rows;
      // At the border of the frame a pixel outside may still show object.
      row[x] = ObjectAround(blocks, block_x, block_y) ? 255
               : there                                ? 0
                                                      : unknown;
    }
  }
  return result;
}

}  // namespace

ReducedMask ReduceMask(const cv::Mat& mask,
                       const SparseCamera& camera,
                       const Frame& frame,
                       int max_size) {
  const CameraProjector projector(camera);
  const CameraIntrinsics& intrinsics = projector.Intrinsics();
  const bool touches = TouchesBorder(mask);
  int k =
      std::max(1, (std::max(mask.cols, mask.rows) + max_size - 1) / max_size);
  if (IsPinhole(camera)) {
    const int padding = touches ? 0 : 1;
    ReducedMask result;
    result.mask = ReduceBlocks(mask, k, padding);
    result.camera = {result.mask.cols,
                     result.mask.rows,
                     intrinsics.fx / k,
                     intrinsics.fy / k,
                     intrinsics.cx / k + padding,
                     intrinsics.cy / k + padding};
    return result;
  }
  cv::Mat blocks = ReduceBlocks(mask, k, 0);
  const Frame object = FrameOfObject(blocks, k, projector);
  const bool closed = !touches && object.complete;
  const Eigen::AlignedBox2d& tangents =
      closed ? object.tangents : frame.tangents;
  // Wide lenses need coarser blocks for the same number of pixels.
  const double extent = std::max(tangents.sizes().x() * intrinsics.fx,
                                 tangents.sizes().y() * intrinsics.fy);
  const int wide = int(std::ceil(extent / (1.5 * max_size)));
  if (wide > k) {
    k = wide;
    blocks = ReduceBlocks(mask, k, 0);
  }
  ReducedMask result;
  result.camera = CameraOfTangents(
      tangents, intrinsics.fx / k, intrinsics.fy / k, closed ? 3 : 0);
  result.mask = WarpBlocks(
      blocks, k, projector, result.camera, closed ? uint8_t{0} : uint8_t{255});
  return result;
}

}  // namespace octacut
