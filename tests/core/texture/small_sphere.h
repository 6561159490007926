// A painted sphere and photographs of it, computed from the paint itself.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/texture/photographs.h"

namespace octacut::testing {

// Unit sphere: an octahedron divided `levels` times.
inline IndexedMesh SmallSphere(int levels) {
  IndexedMesh mesh;
  mesh.positions = {
      {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4},
                    {2, 1, 4},
                    {1, 3, 4},
                    {3, 0, 4},
                    {2, 0, 5},
                    {1, 2, 5},
                    {3, 1, 5},
                    {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
      const auto key = std::minmax(a, b);
      const auto [place, is_new] =
          middles.emplace(key, uint32_t(mesh.positions.size()));
      if (is_new) {
        mesh.positions.push_back(
            (mesh.positions[a] + mesh.positions[b]).normalized());
      }
      return place->second;
    };
    std::vector<std::array<uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const uint32_t ab = middle(a, b);
      const uint32_t bc = middle(b, c);
      const uint32_t ca = middle(c, a);
      finer.insert(finer.end(),
                   {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

// Blue, green, red of the paint; smooth, without any grey level in common.
inline Eigen::Vector3f Paint(const Eigen::Vector3d& p) {
  return {float(128 + 60 * std::sin(5 * p.x() + 1)),
          float(128 + 60 * std::sin(6 * p.y() + 2)),
          float(128 + 60 * std::sin(7 * p.z() + 3))};
}

// Cameras at distance 4 in the directions, looking at the centre.
inline PhotographPose PoseFrom(const Eigen::Vector3d& direction, int size) {
  PhotographPose pose;
  pose.camera = {size, size, 1.6 * size, 1.6 * size, size / 2.0, size / 2.0};
  const Eigen::Vector3d z = -direction.normalized();
  const Eigen::Vector3d x = z.unitOrthogonal();
  pose.cam_from_world.rotation.row(0) = x.transpose();
  pose.cam_from_world.rotation.row(1) = z.cross(x).transpose();
  pose.cam_from_world.rotation.row(2) = z.transpose();
  pose.cam_from_world.translation =
      -(pose.cam_from_world.rotation * (4 * direction.normalized()));
  return pose;
}

using PaintOf = Eigen::Vector3f (*)(const Eigen::Vector3d&);

inline Photograph PhotographOf(const PhotographPose& pose,
                               const Eigen::Vector3f& gain,
                               PaintOf paint = Paint) {
  Photograph photograph;
  const int size = pose.camera.width;
  photograph.image = cv::Mat(size, size, CV_8UC3, cv::Scalar(0, 0, 255));
  photograph.mask = cv::Mat(size, size, CV_8UC1, cv::Scalar(0));
  const Eigen::Vector3d center = pose.Center();
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const Eigen::Vector3d ray = (pose.cam_from_world.rotation.transpose() *
                                   pose.camera.Unproject({x + 0.5, y + 0.5}))
                                      .normalized();
      const double b = center.dot(ray);
      const double root = b * b - center.squaredNorm() + 1;
      if (root < 0) {
        continue;
      }
      const Eigen::Vector3f color =
          paint(center + (-b - std::sqrt(root)) * ray).cwiseProduct(gain);
      for (int c = 0; c < 3; ++c) {
        photograph.image.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<uint8_t>(color[c]);
      }
      photograph.mask.at<uint8_t>(y, x) = 255;
    }
  }
  return photograph;
}

// The photographs from these directions; `gains` are factors of exposure, all
// one if empty.
inline Photographs PhotographsOf(const std::vector<Eigen::Vector3d>& directions,
                                 int size,
                                 const std::vector<float>& gains = {},
                                 PaintOf paint = Paint) {
  Photographs photographs;
  std::vector<Photograph> all;
  for (size_t i = 0; i < directions.size(); ++i) {
    photographs.poses.push_back(PoseFrom(directions[i], size));
    photographs.poses.back().name = "view" + std::to_string(i);
    const float gain = gains.empty() ? 1.0f : gains[i];
    all.push_back(PhotographOf(
        photographs.poses.back(), Eigen::Vector3f::Constant(gain), paint));
  }
  photographs.max_held = 4;
  photographs.load = [all](size_t i) { return all[i]; };
  return photographs;
}

// 14 directions: axes and corners of a cube.
inline std::vector<Eigen::Vector3d> AllAround() {
  std::vector<Eigen::Vector3d> directions;
  for (int axis = 0; axis < 3; ++axis) {
    directions.push_back(Eigen::Vector3d::Unit(axis));
    directions.push_back(-Eigen::Vector3d::Unit(axis));
  }
  for (int corner = 0; corner < 8; ++corner) {
    directions.emplace_back(
        corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
  }
  return directions;
}

}  // namespace octacut::testing
