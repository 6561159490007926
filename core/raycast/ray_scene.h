// Rays and closest points against a triangle mesh (Embree behind it).
//
// Embree computes in floats; here it only chooses the triangle. Coordinates
// are moved to the mesh's centre and divided by its extent before they are
// rounded, and every returned figure is computed in double precision from
// the mesh as it was given.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <memory>
#include <optional>

#include "core/mesh/indexed_mesh.h"

namespace octacut {

class RayScene {
 public:
  struct Hit {
    double distance;  // along the ray, in units of |direction|
    uint32_t triangle;
    Eigen::Vector2f barycentric;  // of corners 1 and 2

    // Between the values of the triangle's corners.
    template <typename Value>
    Value Mix(const Value& a, const Value& b, const Value& c) const {
      const float u = barycentric.x();
      const float v = barycentric.y();
      return (1 - u - v) * a + u * b + v * c;
    }
  };
  struct Closest {
    Eigen::Vector3d point;
    double distance;
    uint32_t triangle;
  };

  // Copies what it needs: the mesh may go. Triangles without area are legal:
  // no ray hits them, but they have closest points. Throws InputError unless
  // there is at least one triangle, all corner indices are vertices and all
  // coordinates are finite.
  explicit RayScene(const IndexedMesh& mesh);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  // All queries may be called from any thread. `direction` need not be of
  // unit length, but not zero. Triangles are hit from both sides.

  // The nearest hit at `min_distance` or further. Rays through a shared edge
  // or vertex do not slip between the triangles.
  std::optional<Hit> FirstHit(const Eigen::Vector3d& origin,
                              const Eigen::Vector3d& direction,
                              double min_distance = 0) const;
  // Whether anything is hit between the two distances (in units of
  // |direction|; `max_distance` may be infinite).
  bool IsOccluded(const Eigen::Vector3d& origin,
                  const Eigen::Vector3d& direction,
                  double min_distance,
                  double max_distance) const;
  // Exact to double precision. Of triangles at the very same distance the
  // one with the lowest index. The search is faster from `near`, a triangle
  // that is likely to be close; the result does not depend on it.
  Closest ClosestPoint(const Eigen::Vector3d& query,
                       std::optional<uint32_t> near = std::nullopt) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace octacut
