#include "core/refine/move_vertices.h"

#include <Eigen/Geometry>
#include <numeric>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kMoveGrain = 4096;
// Least cosine between the normals of a vertex and of a surface that speaks of
// it.
constexpr float kMinCosineOfMove = 0.3f;

// A mean of vectors.
struct Blend {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float weights = 0;
};

// What `point` says of a vertex.
void AddPoint(const MovedPoints& moved,
              uint32_t point,
              const Eigen::Vector3f& position,
              const Eigen::Vector3f& normal,
              float radius,
              Blend* blend) {
  const LocalSurface& surface = moved.surfaces[point];
  const Eigen::Vector3f offset = position - surface.center;
  const float nearness = 1 - offset.squaredNorm() / (radius * radius);
  if (nearness <= 0 || surface.normal.dot(normal) < kMinCosineOfMove) {
    return;
  }
  const float weight = nearness * nearness;
  blend->weights += weight;
  if (!moved.is_free[point]) {
    return;
  }
  float way = float(moved.offsets[point]) + moved.slopes[point].dot(offset);
  if (moved.is_smooth[point]) {
    way += surface.Height(offset.dot(surface.tangent_u),
                          offset.dot(surface.TangentV())) -
           offset.dot(surface.normal);
  }
  blend->sum += weight * way * surface.normal;
}

}  // namespace

double MoveVertices(const SurfacePoints& points,
                    const MovedPoints& moved,
                    double radius,
                    const Context& context,
                    IndexedMesh* mesh) {
  const size_t count = mesh->positions.size();
  std::vector<double> ways(NumChunks(count, kMoveGrain));
  std::vector<size_t> num_moved(ways.size());
  ParallelChunks(
      context, count, kMoveGrain, [&](size_t chunk, size_t begin, size_t end) {
        for (size_t v = begin; v < end; ++v) {
          const uint32_t own = points.point_of[v];
          if (!moved.is_free[own]) {
            continue;
          }
          const Eigen::Vector3f position = mesh->positions[v].cast<float>();
          Blend blend;
          AddPoint(
              moved, own, position, mesh->normals[v], float(radius), &blend);
          for (const uint32_t point : points.neighbors.Of(own)) {
            AddPoint(moved,
                     point,
                     position,
                     mesh->normals[v],
                     float(radius),
                     &blend);
          }
          if (blend.weights > 0) {
            const Eigen::Vector3d way =
                (blend.sum / blend.weights).cast<double>();
            mesh->positions[v] += way;
            ways[chunk] += way.norm();
            ++num_moved[chunk];
          }
        }
      });
  const size_t num =
      std::accumulate(num_moved.begin(), num_moved.end(), size_t{0});
  return std::accumulate(ways.begin(), ways.end(), 0.0) /
         double(std::max<size_t>(num, 1));
}

}  // namespace octacut
