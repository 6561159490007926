// Random views and cubes, and the way between world and unit coordinates, for
// the tests of the steps that work on views.
#pragma once

#include <cmath>
#include <Eigen/Geometry>
#include <random>

#include "core/benchmark/synthetic/rig.h"
#include "core/scene/scene.h"

namespace octacut::testing {

inline Eigen::Vector3d ToWorld(const BoundingCube& cube,
                               const Eigen::Vector3d& unit) {
  return cube.min_corner + cube.edge * unit;
}
inline Eigen::Vector3d ToUnit(const BoundingCube& cube,
                              const Eigen::Vector3d& world) {
  return (world - cube.min_corner) / cube.edge;
}

class Random {
 public:
  explicit Random(uint32_t seed) : generator_(seed) {}
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  int Integer(int low, int high) {  // both included
    return std::uniform_int_distribution<int>(low, high)(generator_);
  }
  Eigen::Vector3d Point(double low, double high) {
    const double x = Uniform(low, high);
    const double y = Uniform(low, high);
    return {x, y, Uniform(low, high)};
  }
  Eigen::Vector3d Direction() {
    while (true) {
      const Eigen::Vector3d v = Point(-1, 1);
      if (v.norm() > 0.1 && v.norm() < 1) {
        return v.normalized();
      }
    }
  }

 private:
  std::mt19937 generator_;
};

// A cube somewhere and a camera that looks at about its centre from outside;
// neither image nor mask.
struct ViewOfCube {
  BoundingCube cube;
  View view;
};
inline ViewOfCube RandomViewOfCube(Random& random, double far_from_origin) {
  ViewOfCube result;
  result.cube.min_corner = random.Point(-far_from_origin, far_from_origin);
  result.cube.edge = std::pow(10.0, random.Uniform(-2, 2));
  PinholeCamera& camera = result.view.camera;
  camera.width = random.Integer(100, 400);
  camera.height = random.Integer(100, 400);
  camera.fx = random.Uniform(0.8, 1.4) * camera.width;
  camera.fy = camera.fx * random.Uniform(0.9, 1.1);
  camera.cx = camera.width * random.Uniform(0.4, 0.6);
  camera.cy = camera.height * random.Uniform(0.4, 0.6);
  const Eigen::Vector3d eye =
      result.cube.Center() +
      result.cube.edge * random.Uniform(1.5, 3) * random.Direction();
  const Eigen::Vector3d target = ToWorld(result.cube, random.Point(0.3, 0.7));
  result.view.cam_from_world =
      LookAt(eye, target, random.Direction().cross(target - eye));
  result.view.name = "random";
  return result;
}

}  // namespace octacut::testing
