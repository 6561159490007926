// Rays and closest points against a triangle mesh (Embree behind it).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <Eigen/Core>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

class RayScene {
 public:
  struct Hit {
    double distance;         // along the ray, in units of |direction|
    uint32_t triangle;
    Eigen::Vector2f barycentric;  // of corners 1 and 2
  };
  struct Closest {
    Eigen::Vector3d point;
    double distance;
    uint32_t triangle;
  };

  // Copies what it needs: the mesh may go. At least one triangle.
  explicit RayScene(const IndexedMesh& mesh);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  // All queries may be called from any thread.
  std::optional<Hit> FirstHit(const Eigen::Vector3d& origin,
                              const Eigen::Vector3d& direction,
                              double min_distance = 0) const;
  bool IsOccluded(const Eigen::Vector3d& origin,
                  const Eigen::Vector3d& direction,
                  double min_distance,
                  double max_distance) const;
  Closest ClosestPoint(const Eigen::Vector3d& query) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace octacut
