#include "core/texture/seam_jumps.h"

#include "core/texture/pixel_sampler.h"

namespace octacut {
namespace {

constexpr std::array<float, 3> kPlacesAlongEdge = {0.25f, 0.5f, 0.75f};

// Weights of a triangle's corners for the point from `a` to `b`.
Eigen::Vector3f EdgeWeights(const std::array<uint32_t, 3>& corners,
                            uint32_t a,
                            uint32_t b,
                            float part) {
  Eigen::Vector3f weights = Eigen::Vector3f::Zero();
  for (int k = 0; k < 3; ++k) {
    if (corners[size_t(k)] == a) {
      weights[k] = 1 - part;
    } else if (corners[size_t(k)] == b) {
      weights[k] = part;
    }
  }
  return weights;
}

}  // namespace

SeamPoints::SeamPoints(const IndexedMesh& mesh,
                       const std::vector<std::array<uint32_t, 3>>& neighbors,
                       const AtlasLayout& layout) {
  const auto view_of = [&](uint32_t f) {
    return layout.charts.charts[layout.charts.chart_of_face[f]].view;
  };
  for (uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t other = neighbors[f][k];
      if (other == kNoFace || other < f || view_of(f) == view_of(other) ||
          view_of(f) == kNoView || view_of(other) == kNoView) {
        continue;
      }
      const uint32_t a = mesh.triangles[f][k];
      const uint32_t b = mesh.triangles[f][(k + 1) % 3];
      for (const float part : kPlacesAlongEdge) {
        Point point;
        point.position = (1 - double(part)) * mesh.positions[a] +
                         double(part) * mesh.positions[b];
        point.sides[0] = {
            f, view_of(f), EdgeWeights(mesh.triangles[f], a, b, part)};
        point.sides[1] = {other,
                          view_of(other),
                          EdgeWeights(mesh.triangles[other], a, b, part)};
        points_.push_back(point);
      }
    }
  }
}

void SeamPoints::Sample(uint32_t view,
                        const PhotographPose& pose,
                        const cv::Mat& image) {
  for (Point& point : points_) {
    for (Side& side : point.sides) {
      if (side.view == view) {
        const Eigen::Vector2d pixel =
            pose.camera.Project(pose.cam_from_world * point.position);
        side.raw = SamplePixels(image, pixel.x(), pixel.y());
      }
    }
  }
}

SeamJumps SeamPoints::Measure(const TexturedMesh& textured) const {
  SeamJumps jumps;
  jumps.num_points = points_.size();
  for (const Point& point : points_) {
    std::array<Eigen::Vector3f, 2> colors;
    for (size_t s = 0; s < 2; ++s) {
      const Side& side = point.sides[s];
      const cv::Mat& page = textured.pages[textured.PageOf(side.face)].color;
      Eigen::Vector2f uv = Eigen::Vector2f::Zero();
      for (int k = 0; k < 3; ++k) {
        uv += side.weights[k] * textured.texcoords[side.face][size_t(k)];
      }
      colors[s] = SamplePixels(
          page, double(uv.x()) * page.cols, double(uv.y()) * page.rows);
    }
    jumps.before +=
        double((point.sides[0].raw - point.sides[1].raw).cwiseAbs().sum()) / 3;
    jumps.after += double((colors[0] - colors[1]).cwiseAbs().sum()) / 3;
  }
  if (!points_.empty()) {
    jumps.before /= double(points_.size());
    jumps.after /= double(points_.size());
  }
  return jumps;
}

}  // namespace octacut
