#include "core/mesh/surface_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Core>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {
namespace {

constexpr size_t kSampleGrain = 8192;

// Fixed-point multiples of the inverse of the plastic number and its square.
constexpr uint64_t kR2First = 0xc13fa9a902a6328f;
constexpr uint64_t kR2Second = 0x91e10da5c79e7b1d;

}  // namespace

std::vector<double> CumulativeAreas(const IndexedMesh& mesh,
                                    size_t begin,
                                    size_t end) {
  std::vector<double> cumulative;
  cumulative.reserve(end - begin);
  double total = 0;
  for (size_t i = begin; i < end; ++i) {
    total += TriangleArea(mesh, mesh.triangles[i]);
    cumulative.push_back(total);
  }
  return cumulative;
}

Eigen::Vector3d PointInTriangle(const IndexedMesh& mesh,
                                uint32_t triangle,
                                double u,
                                double v) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  // The square's lower left half is the triangle; its other half is folded
  // over, which keeps the area.
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Eigen::Vector3d& origin = mesh.positions[a];
  return origin + u * (mesh.positions[b] - origin) +
         v * (mesh.positions[c] - origin);
}

std::vector<SurfaceSample> SampleSurface(const IndexedMesh& mesh,
                                         size_t count,
                                         uint64_t seed,
                                         const Context& context) {
  const std::vector<double> cumulative =
      CumulativeAreas(mesh, 0, mesh.triangles.size());
  const double total = cumulative.empty() ? 0 : cumulative.back();
  if (!(total > 0) || !std::isfinite(total)) {
    throw InputError(
        fmt::format("mesh to sample: its {} triangles have the area {}",
                    mesh.triangles.size(),
                    total));
  }
  const double piece = total / static_cast<double>(count);
  const uint64_t seed_mix = HashBits(seed);
  const uint64_t shift_first = HashBits(seed_mix + 1);
  const uint64_t shift_second = HashBits(seed_mix + 2);
  std::vector<SurfaceSample> samples(count);
  ParallelEach(context, count, kSampleGrain, [&](size_t i) {
    const double jitter = HashUniform(HashBits(seed_mix ^ HashBits(i)));
    const double area = (static_cast<double>(i) + jitter) * piece;
    auto found = std::upper_bound(cumulative.begin(), cumulative.end(), area);
    if (found == cumulative.end()) {
      // Rounding: the first triangle that reaches the whole area.
      found = std::lower_bound(cumulative.begin(), cumulative.end(), total);
    }
    const auto triangle = static_cast<uint32_t>(found - cumulative.begin());
    samples[i] = {PointInTriangle(mesh,
                                  triangle,
                                  HashUniform(i * kR2First + shift_first),
                                  HashUniform(i * kR2Second + shift_second)),
                  triangle};
  });
  return samples;
}

}  // namespace octacut
