#include "core/verdict/judge_mesh.h"

#include <utility>

#include "core/base/stopwatch.h"
#include "core/raycast/ray_scene.h"
#include "core/verdict/removed_parts.h"

namespace octacut {
namespace {

IndexedMesh ToUnit(const IndexedMesh& mesh, const BoundingCube& cube) {
  IndexedMesh unit;
  unit.triangles = mesh.triangles;
  for (const Eigen::Vector3d& position : mesh.positions) {
    unit.positions.push_back((position - cube.min_corner) / cube.edge);
  }
  return unit;
}

std::vector<BorderUncertainty> UncertaintiesOf(const std::vector<View>& views,
                                               const JudgeOptions& options) {
  std::vector<BorderUncertainty> uncertainties;
  for (const View& view : views) {
    uncertainties.push_back(UncertaintyOfBorders(
        options.border_shift, options.mask_tolerance * view.scale));
  }
  return uncertainties;
}

}  // namespace

MeshVerdict JudgeMesh(const IndexedMesh& mesh,
                      const IndexedMesh& removed,
                      const JudgedScene& scene,
                      const JudgeOptions& options,
                      const Context& context) {
  Stopwatch stopwatch;
  MeshVerdict verdict;
  const IndexedMesh unit = ToUnit(mesh, scene.cube);
  SilhouetteCheck check =
      CheckSilhouettes(RayScene(unit),
                       scene.given,
                       scene.repaired,
                       scene.views,
                       UncertaintiesOf(scene.given, options),
                       context);
  verdict.removed_pixels = CountPixelsOfRemoved(
      ToUnit(removed, scene.cube), scene.views, check.missed, context);
  verdict.given_masks = std::move(check.given);
  verdict.repaired_masks = std::move(check.repaired);
  verdict.silhouette_seconds = stopwatch.Lap();
  return verdict;
}

}  // namespace octacut
