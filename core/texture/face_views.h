// Which photographs show a triangle, how well, and in which colour.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/raycast/ray_scene.h"
#include "core/texture/photographs.h"

namespace octacut {

// A photograph that shows all of a triangle.
struct FaceView {
  // Pixels per unit of length in the direction in which the triangle is most
  // foreshortened.
  float resolution;
  // Mean gradient of the grey values over the triangle: levels a unit of
  // length on the surface.
  float contrast;
  uint16_t view;
  std::array<uint8_t, 3> color;  // blue, green, red; mean over the triangle
  // Away from the border of the mask and from occluding contours, where pixels
  // mix the object with what is beside or behind it, and seen at less than 75
  // degrees. Where a triangle has such views, it has no others.
  uint8_t is_sure;

  Eigen::Vector3f Color() const {
    return {float(color[0]), float(color[1]), float(color[2])};
  }
};

// The best views of each triangle: sure ones first, then by resolution.
class FaceViews {
 public:
  // More than this do not change the choice of a view, nor the vote on colours.
  static constexpr size_t kMaxViews = 16;

  explicit FaceViews(size_t num_faces)
      : views_(num_faces * kMaxViews), counts_(num_faces, 0) {}

  size_t NumFaces() const { return counts_.size(); }
  std::span<const FaceView> Of(size_t face) const {
    return {views_.data() + face * kMaxViews, counts_[face]};
  }
  std::span<FaceView> Of(size_t face) {
    return {views_.data() + face * kMaxViews, counts_[face]};
  }
  // The view's entry, or null where it does not show the triangle.
  const FaceView* Find(size_t face, uint32_t view) const {
    for (const FaceView& candidate : Of(face)) {
      if (candidate.view == view) {
        return &candidate;
      }
    }
    return nullptr;
  }
  // Takes `candidate` in, where it is among the best. Views must be added in
  // the same order each time for the same result.
  void Add(size_t face, const FaceView& candidate);

 private:
  std::vector<FaceView> views_;
  std::vector<uint8_t> counts_;
};

// Pixels from the border of a mask or an occluding contour within which a view
// is not sure: lenses and demosaicing spread an edge over one or two pixels,
// outlines of meshes are off by a fraction of one, and the margins of charts
// take one more.
inline constexpr double kGuardPixels = 2.5;

// Reads every photograph once, as many at a time as `photographs` allows.
FaceViews FindFaceViews(const IndexedMesh& mesh,
                        const RayScene& rays,
                        const Photographs& photographs,
                        const Context& context);

}  // namespace octacut
