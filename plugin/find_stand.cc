#include "plugin/find_stand.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/segment/search_region.h"
#include "core/segment/stand_pixels.h"
#include "core/segment/stand_plane.h"
#include "core/segment/turntable_views.h"

namespace octacut {
namespace {

// Views in which a sparse point of the stand is seen, at least: of two, its
// distance may be wrong.
constexpr size_t kMinTrack = 3;

// The pixels of a turntable's views that show points of the stand.
void MarkPoints(const std::vector<const SparsePoint*>& points,
                SegmentationFiles* files) {
  std::map<uint32_t, size_t> view_of_image;
  for (size_t i = 0; i < files->files.size(); ++i) {
    if (files->input.views[i].is_turntable) {
      view_of_image[files->files[i].image->id] = i;
    }
  }
  for (const SparsePoint* point : points) {
    for (const TrackElement& element : point->track) {
      const auto found = view_of_image.find(element.image_id);
      if (found == view_of_image.end()) {
        continue;
      }
      UnsegmentedView& view = files->input.views[found->second];
      if (const auto pixel = PixelOf(view.pose, point->xyz)) {
        view.stand_points.push_back(*pixel);
      }
    }
  }
}

}  // namespace

void FindStand(const SparseModel& model,
               bool is_required,
               const Context& context,
               SegmentationFiles* files) {
  SegmentationInput& input = files->input;
  std::vector<Pose> poses;
  std::vector<cv::Mat> images;
  for (const UnsegmentedView& view : input.views) {
    poses.push_back(view.pose);
    images.push_back(view.image);
  }
  std::vector<Eigen::Vector3d> points;
  std::vector<const SparsePoint*> sparse_points;
  for (const SparsePoint& point : model.points) {
    if (point.track.size() >= kMinTrack) {
      points.push_back(point.xyz);
      sparse_points.push_back(&point);
    }
  }
  const SearchRegion region = FindSearchRegion(poses, input.box);
  const std::optional<StandPlane> stand = FindStandPlane(points, poses, region);
  if (!stand && is_required) {
    throw InputError(fmt::format(
        "on_stand = 1: none of the planes through the {} sparse points that "
        "three views see has the object above it and nothing below; "
        "`bounding_box` or strokes can leave the stand out",
        points.size()));
  }
  if (!stand) {
    return;
  }
  const auto find_pixels = [&] {
    return FindStandPixels(images, poses, stand->plane, region.center, context);
  };
  std::vector<cv::Mat> pixels;
  if (!is_required) {
    pixels = find_pixels();
    if (!IsStand(pixels, poses, region)) {
      return;
    }
  }
  // What is left of the stand's surface by noise is cut off as well.
  input.floor = stand->plane;
  input.floor->offset() -= stand->tolerance;
  UseTurntable(region, context, &input);
  for (size_t i = 0; i < poses.size(); ++i) {
    // Of a turntable, what does not show the stand is object or background that
    // stands still; chance matches there would be learned as the stand's.
    if (!input.views[i].is_turntable) {
      if (pixels.empty()) {
        pixels = find_pixels();
      }
      input.views[i].stand = pixels[i];
    }
  }
  std::erase_if(sparse_points, [&](const SparsePoint* point) {
    return std::abs(stand->plane.signedDistance(point->xyz)) > stand->tolerance;
  });
  MarkPoints(sparse_points, files);
  context.Info(
      fmt::format("The object stands on a plane that {} sparse points show. "
                  "The plane and everything below it are background.",
                  sparse_points.size()));
}

}  // namespace octacut
