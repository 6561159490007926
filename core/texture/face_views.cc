#include "core/texture/face_views.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

#include "core/base/parallel.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/mean_edge.h"
#include "core/mesh/triangle_normal.h"
#include "core/texture/face_neighbors.h"
#include "core/texture/occlusion_guard.h"
#include "core/texture/pixel_sampler.h"

namespace octacut {
namespace {

// Cosines of the angles to the normal up to which a view is sure (75 degrees)
// and of use at all (85 degrees): a pixel covers four and eleven times its
// width there.
constexpr double kMinSureCosine = 0.26;
constexpr double kMinCosine = 0.087;
// Pixels between the samples of a triangle that show whether it is hidden, and
// what its colour is; at most kMaxSamples a side.
constexpr double kOcclusionSpacing = 8;
constexpr double kColorSpacing = 2;
constexpr int kMaxSamples = 8;
// Of triangles of fewer pixels, the corners show whether they are hidden.
constexpr double kSmallTriangle = 8;

struct FoundView {
  uint32_t face;
  FaceView view;
};

bool IsBetter(const FaceView& a, const FaceView& b) {
  return a.is_sure != b.is_sure ? a.is_sure > b.is_sure
                                : a.resolution > b.resolution;
}

// Calls body(weights of the corners) for n (n + 1) / 2 points spread over a
// triangle; its centre for n = 1. Stops where body returns false.
template <typename Body>
bool ForSamples(int n, const Body& body) {
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      const double a = (i + 1.0 / 3) / n;
      const double b = (j + 1.0 / 3) / n;
      if (!body(Eigen::Vector3d(1 - a - b, a, b))) {
        return false;
      }
    }
  }
  return true;
}

int SamplesASide(double pixels, double spacing) {
  return std::clamp(
      int(std::ceil(std::sqrt(pixels) / spacing)), 1, kMaxSamples);
}

// What does not depend on the view.
struct Surface {
  const IndexedMesh& mesh;
  const RayScene& rays;
  std::vector<std::array<uint32_t, 3>> neighbors;
  std::vector<Eigen::Vector3f> normals;  // of triangles, twice their areas long
  // Length that rays toward the camera skip, since they begin on the surface.
  double ray_offset = 0;
  double mean_edge = 0;
};

Surface MakeSurface(const IndexedMesh& mesh, const RayScene& rays) {
  Surface surface{mesh, rays, FindFaceNeighbors(mesh), {}};
  for (const auto& triangle : mesh.triangles) {
    surface.normals.push_back(AreaNormal(mesh, triangle).cast<float>());
  }
  surface.mean_edge = MeanEdge(mesh);
  // Embree's floats resolve a millionth of the size.
  surface.ray_offset = std::max(0.1 * surface.mean_edge,
                                4e-6 * BoxOfTriangles(mesh).diagonal().norm());
  return surface;
}

// The triangles of one photograph.
class ViewScan {
 public:
  ViewScan(const Surface& surface,
           const PhotographPose& pose,
           const Photograph& photograph,
           uint16_t view)
      : surface_(surface),
        pose_(pose),
        photograph_(photograph),
        view_(view),
        center_(pose.Center()),
        guard_(pose.camera, photograph.mask, 2 * surface.mean_edge) {
    const IndexedMesh& mesh = surface.mesh;
    in_camera_.resize(mesh.positions.size());
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
      in_camera_[v] = (pose.cam_from_world * mesh.positions[v]).cast<float>();
    }
    cosines_.resize(mesh.triangles.size());
    std::vector<uint8_t> is_front(mesh.triangles.size());
    for (size_t f = 0; f < mesh.triangles.size(); ++f) {
      cosines_[f] = Cosine(f);
      is_front[f] = cosines_[f] > 0;
    }
    guard_.AddContours(mesh.triangles, surface.neighbors, is_front, in_camera_);
  }

  std::vector<FoundView> Run() {
    visible_.assign(surface_.mesh.positions.size(), kUnknown);
    std::vector<FoundView> found;
    for (size_t f = 0; f < surface_.mesh.triangles.size(); ++f) {
      FaceView view;
      if (Look(f, &view)) {
        found.push_back({uint32_t(f), view});
      }
    }
    return found;
  }

 private:
  enum Seen : uint8_t { kUnknown, kVisible, kHidden };

  float Cosine(size_t f) const {
    const Eigen::Vector3d toward =
        center_ - surface_.mesh.positions[surface_.mesh.triangles[f][0]];
    const Eigen::Vector3d normal = surface_.normals[f].cast<double>();
    const double scale = normal.norm() * toward.norm();
    return scale > 0 ? float(normal.dot(toward) / scale) : 0.0f;
  }

  bool IsVisible(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d toward = center_ - point;
    const double distance = toward.norm();
    return !surface_.rays.IsOccluded(
        point, toward / distance, surface_.ray_offset, distance);
  }

  bool IsVertexVisible(uint32_t v) {
    if (visible_[v] == kUnknown) {
      visible_[v] = IsVisible(surface_.mesh.positions[v]) ? kVisible : kHidden;
    }
    return visible_[v] == kVisible;
  }

  bool Look(size_t f, FaceView* view) {
    if (cosines_[f] < kMinCosine) {
      return false;
    }
    const auto& corners = surface_.mesh.triangles[f];
    Eigen::Matrix<double, 3, 3> points;  // u, v, depth of the corners
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d point = in_camera_[corners[k]].cast<double>();
      if (!(point.z() > 0)) {
        return false;
      }
      const Eigen::Vector2d pixel = pose_.camera.Project(point);
      if (!guard_.IsObject(pixel.x(), pixel.y())) {
        return false;
      }
      points.col(k) << pixel, point.z();
    }
    const Eigen::Vector2d ab = (points.col(1) - points.col(0)).head<2>();
    const Eigen::Vector2d ac = (points.col(2) - points.col(0)).head<2>();
    const double pixels = std::abs(ab.x() * ac.y() - ab.y() * ac.x()) / 2;
    if (!(pixels > 0) || !IsShown(f, points, pixels)) {
      return false;
    }
    view->view = view_;
    view->is_sure =
        cosines_[f] >= kMinSureCosine && IsSure(points, pixels) ? 1 : 0;
    const double area = double(surface_.normals[f].norm()) / 2;
    const double density = std::sqrt(pixels / (area * cosines_[f]));
    view->resolution = float(density * cosines_[f]);
    Measure(points, pixels, density, view);
    return true;
  }

  // Whether mask and occluders leave all of the triangle in sight.
  bool IsShown(size_t f, const Eigen::Matrix3d& points, double pixels) {
    const auto& corners = surface_.mesh.triangles[f];
    for (const uint32_t corner : corners) {
      if (!IsVertexVisible(corner)) {
        return false;
      }
    }
    if (pixels <= kSmallTriangle) {
      return true;
    }
    return ForSamples(
        SamplesASide(pixels, kOcclusionSpacing), [&](const auto& weights) {
          const Eigen::Vector3d pixel = points * weights;
          const Eigen::Vector3d point =
              weights[0] * surface_.mesh.positions[corners[0]] +
              weights[1] * surface_.mesh.positions[corners[1]] +
              weights[2] * surface_.mesh.positions[corners[2]];
          return guard_.IsObject(pixel.x(), pixel.y()) && IsVisible(point);
        });
  }

  bool IsSure(const Eigen::Matrix3d& points, double pixels) const {
    for (int k = 0; k < 3; ++k) {
      if (!guard_.IsSure(points(0, k), points(1, k), points(2, k))) {
        return false;
      }
    }
    return ForSamples(SamplesASide(pixels, kColorSpacing),
                      [&](const auto& weights) {
                        const Eigen::Vector3d pixel = points * weights;
                        return guard_.IsSure(pixel.x(), pixel.y(), pixel.z());
                      });
  }

  static float Grey(const Eigen::Vector3f& color) { return color.sum() / 3; }

  void Measure(const Eigen::Matrix3d& points,
               double pixels,
               double density,
               FaceView* view) const {
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    float gradient = 0;
    int count = 0;
    ForSamples(SamplesASide(pixels, kColorSpacing), [&](const auto& weights) {
      const double u = points.row(0).dot(weights);
      const double v = points.row(1).dot(weights);
      const cv::Mat& image = photograph_.image;
      color += SamplePixels(image, u, v);
      const float across = Grey(SamplePixels(image, u + 0.5, v)) -
                           Grey(SamplePixels(image, u - 0.5, v));
      const float along = Grey(SamplePixels(image, u, v + 0.5)) -
                          Grey(SamplePixels(image, u, v - 0.5));
      gradient += std::hypot(across, along);
      ++count;
      return true;
    });
    for (int c = 0; c < 3; ++c) {
      view->color[c] = uint8_t(std::lround(color[c] / float(count)));
    }
    view->contrast = gradient / float(count) * float(density);
  }

  const Surface& surface_;
  const PhotographPose& pose_;
  const Photograph& photograph_;
  const uint16_t view_;
  const Eigen::Vector3d center_;
  std::vector<Eigen::Vector3f> in_camera_;
  std::vector<float> cosines_;
  std::vector<uint8_t> visible_;
  OcclusionGuard guard_;
};

}  // namespace

void FaceViews::Add(size_t face, const FaceView& candidate) {
  const std::span<FaceView> all(views_.data() + face * kMaxViews, kMaxViews);
  size_t count = counts_[face];
  if (count > 0 && all[0].is_sure != candidate.is_sure) {
    if (all[0].is_sure) {
      return;
    }
    count = 0;
  }
  size_t place = count;
  while (place > 0 && IsBetter(candidate, all[place - 1])) {
    --place;
  }
  if (place == kMaxViews) {
    return;
  }
  count = std::min(count + 1, kMaxViews);
  std::move_backward(
      all.begin() + place, all.begin() + count - 1, all.begin() + count);
  all[place] = candidate;
  counts_[face] = uint8_t(count);
}

FaceViews FindFaceViews(const IndexedMesh& mesh,
                        const RayScene& rays,
                        const Photographs& photographs,
                        const Context& context) {
  const Surface surface = MakeSurface(mesh, rays);
  FaceViews result(mesh.triangles.size());
  const size_t num_views = photographs.poses.size();
  Phase phase(context, "visibility", num_views);
  // Batches are added in the order of the views, whatever their size.
  const size_t batch =
      std::clamp(photographs.max_held, size_t{1}, size_t(context.NumThreads()));
  for (size_t first = 0; first < num_views; first += batch) {
    const size_t count = std::min(batch, num_views - first);
    std::vector<std::vector<FoundView>> found(count);
    ParallelEach(context, count, 1, [&](size_t i) {
      const size_t view = first + i;
      const Photograph photograph = photographs.load(view);
      found[i] =
          ViewScan(surface, photographs.poses[view], photograph, uint16_t(view))
              .Run();
      phase.Advance();
    });
    for (const auto& views : found) {
      for (const FoundView& view : views) {
        result.Add(view.face, view.view);
      }
    }
  }
  return result;
}

}  // namespace octacut
