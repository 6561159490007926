#include "core/benchmark/synthetic/polygonize.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/benchmark/synthetic/marching_tetrahedra.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {

void PolygonizeOptions::Check() const {
  CheckOption(resolution >= 8 && resolution <= 4096,
              "reference.resolution",
              resolution,
              "must be in [8, 4096]");
  CheckOption(smoothing_rounds >= 0,
              "smoothing_rounds",
              smoothing_rounds,
              "must not be negative");
}

namespace {

using Eigen::Vector3d;

constexpr size_t kVertexGrain = 1024;

// Steps of differences, in cells.
constexpr double kDifference = 1e-3;
// How far vertices may be from the surface, in cells.
constexpr double kTolerance = 1e-6;

// A Newton step along `gradient`, no further than a cell.
void StepToSurface(const ImplicitShape& shape,
                   const Vector3d& gradient,
                   double cell,
                   Vector3d& point) {
  const double slope_squared = gradient.squaredNorm();
  if (slope_squared < 1e-6) {
    return;
  }
  const Vector3d move = -shape(point) / slope_squared * gradient;
  const double length = move.norm();
  point += (length > cell ? cell / length : 1.0) * move;
}

// Two values instead of the gradient's four and one: the mesh's own normals
// tell the direction well enough.
void StepAlongNormal(const ImplicitShape& shape,
                     const Vector3d& normal,
                     double cell,
                     Vector3d& point) {
  const double step = kDifference * cell;
  const double value = shape(point);
  const double slope = (shape(point + step * normal) - value) / step;
  if (slope > 0.1) {
    point -= std::clamp(value / slope, -cell, cell) * normal;
  }
}

// Every vertex half way to the mean of its neighbours; gives the normals.
std::vector<Vector3d> SmoothVertices(IndexedMesh& mesh) {
  std::vector<Vector3d> sums(mesh.positions.size(), Vector3d::Zero());
  std::vector<Vector3d> normals(mesh.positions.size(), Vector3d::Zero());
  std::vector<int> counts(mesh.positions.size(), 0);
  for (const auto& triangle : mesh.triangles) {
    const Vector3d normal = AreaNormal(mesh, triangle);
    for (int k = 0; k < 3; ++k) {
      // Each neighbour is the next corner in exactly one triangle.
      sums[triangle[k]] += mesh.positions[triangle[(k + 1) % 3]];
      normals[triangle[k]] += normal;
      ++counts[triangle[k]];
    }
  }
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] = (mesh.positions[i] + sums[i] / counts[i]) / 2;
    normals[i].normalize();
  }
  return normals;
}

// Throws unless every edge has two triangles that run it in opposite
// directions.
void ThrowUnlessClosed(const IndexedMesh& mesh) {
  std::vector<uint64_t> forward;
  std::vector<uint64_t> backward;
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const uint64_t from = triangle[k];
      const uint64_t to = triangle[(k + 1) % 3];
      forward.push_back(from << 32 | to);
      backward.push_back(to << 32 | from);
    }
  }
  std::sort(forward.begin(), forward.end());
  std::sort(backward.begin(), backward.end());
  if (forward != backward ||
      std::adjacent_find(forward.begin(), forward.end()) != forward.end()) {
    throw InvariantError(
        "implicit shape: its Lipschitz bound is too small, the mesh is open");
  }
}

}  // namespace

IndexedMesh Polygonize(const ImplicitShape& shape,
                       const PolygonizeOptions& options,
                       const Context& context) {
  options.Check();
  MarchedSurface marched = MarchTetrahedra(shape, options.resolution, context);
  const double cell = marched.cell;
  IndexedMesh mesh = std::move(marched.mesh);
  if (mesh.triangles.empty()) {
    throw InputError("implicit shape: no surface at this resolution");
  }
  ThrowUnlessClosed(mesh);
  auto& positions = mesh.positions;
  const auto gradient_at = [&](const Vector3d& p) {
    return ImplicitGradient(shape, p, kDifference * cell);
  };
  ParallelEach(context, positions.size(), kVertexGrain, [&](size_t i) {
    StepToSurface(shape, gradient_at(positions[i]), cell, positions[i]);
  });
  for (int round = 0; round < options.smoothing_rounds; ++round) {
    const std::vector<Vector3d> normals = SmoothVertices(mesh);
    ParallelEach(context, positions.size(), kVertexGrain, [&](size_t i) {
      StepAlongNormal(shape, normals[i], cell, positions[i]);
    });
  }
  mesh.normals.resize(positions.size());
  ParallelEach(context, positions.size(), kVertexGrain, [&](size_t i) {
    // One gradient serves several steps, but not on the sharpest edges.
    for (int round = 0; round < 3; ++round) {
      const Vector3d gradient = gradient_at(positions[i]);
      mesh.normals[i] = gradient.normalized().cast<float>();
      StepToSurface(shape, gradient, cell, positions[i]);
      StepToSurface(shape, gradient, cell, positions[i]);
      if (std::abs(shape(positions[i])) < kTolerance * cell) {
        break;
      }
    }
  });
  return mesh;
}

}  // namespace octacut
