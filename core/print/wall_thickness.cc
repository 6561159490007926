#include "core/print/wall_thickness.h"

#include <algorithm>
#include <Eigen/Geometry>
#include <optional>

#include "core/base/parallel.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/surface_samples.h"
#include "core/mesh/triangle_normal.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 2048;
constexpr size_t kNumBins = 20;
constexpr size_t kNumPlaces = 10;
// cos 45 degrees.
constexpr double kMinFacing = 0.70710678;
// Shares of the diagonal: between a ray's origin and the first hit that counts,
// above what floats resolve; and between thin places.
constexpr double kMinDistance = 1e-6;
constexpr double kPlaceSpacing = 0.05;

Eigen::Vector3d UnitNormal(const IndexedMesh& mesh, uint32_t triangle) {
  return AreaNormal(mesh, mesh.triangles[triangle]).normalized();
}

std::optional<double> ThicknessAt(const SurfaceSample& sample,
                                  const IndexedMesh& mesh,
                                  const RayScene& scene,
                                  double min_distance) {
  const Eigen::Vector3d inward = -UnitNormal(mesh, sample.triangle);
  const auto hit = scene.FirstHit(sample.point, inward, min_distance);
  if (!hit || UnitNormal(mesh, hit->triangle).dot(inward) < kMinFacing) {
    return std::nullopt;
  }
  return hit->distance;
}

// `places` are sorted, thinnest first.
std::vector<ThinPlace> SpreadPlaces(const std::vector<ThinPlace>& places,
                                    double spacing,
                                    size_t max_count) {
  std::vector<ThinPlace> kept;
  for (const ThinPlace& place : places) {
    if (kept.size() == max_count) {
      break;
    }
    if (std::none_of(kept.begin(), kept.end(), [&](const ThinPlace& other) {
          return (other.point - place.point).norm() < spacing;
        })) {
      kept.push_back(place);
    }
  }
  return kept;
}

}  // namespace

WallThickness MeasureWallThickness(const IndexedMesh& mesh,
                                   const WallThicknessOptions& options,
                                   const Context& context) {
  const std::vector<SurfaceSample> samples =
      SampleSurface(mesh, size_t(options.num_samples), context.Seed(), context);
  const double diagonal = BoxOfTriangles(mesh).diagonal().norm();
  const RayScene scene(mesh);
  std::vector<double> thickness(samples.size(), -1);
  {
    Phase phase(context, "wall thickness", samples.size());
    ParallelFor(context, samples.size(), kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        thickness[i] =
            ThicknessAt(samples[i], mesh, scene, kMinDistance * diagonal)
                .value_or(-1);
      }
      phase.Advance(end - begin);
    });
  }
  std::vector<ThinPlace> places;
  for (size_t i = 0; i < samples.size(); ++i) {
    if (thickness[i] >= 0) {
      places.push_back({samples[i].point, thickness[i]});
    }
  }
  WallThickness result;
  result.measured_share = double(places.size()) / double(samples.size());
  result.histogram.resize(kNumBins);
  if (places.empty()) {
    return result;
  }
  std::stable_sort(
      places.begin(), places.end(), [](const ThinPlace& a, const ThinPlace& b) {
        return a.thickness < b.thickness;
      });
  const auto quantile = [&](double fraction) {
    return places[size_t(fraction * double(places.size() - 1))].thickness;
  };
  result.min = quantile(0);
  result.percentile_1 = quantile(0.01);
  result.percentile_5 = quantile(0.05);
  result.median = quantile(0.5);
  result.max = quantile(1);
  for (const ThinPlace& place : places) {
    result.thin_share +=
        place.thickness < options.min_wall ? 1 / double(places.size()) : 0;
    const double bin = double(kNumBins) * place.thickness / result.max;
    result.histogram[std::min(size_t(bin), kNumBins - 1)] +=
        1 / double(places.size());
  }
  result.thinnest = SpreadPlaces(places, kPlaceSpacing * diagonal, kNumPlaces);
  return result;
}

}  // namespace octacut
