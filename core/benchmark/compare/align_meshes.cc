#include "core/benchmark/compare/align_meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <Eigen/Geometry>
#include <string>

#include "core/base/check_option.h"
#include "core/benchmark/compare/global_alignment.h"
#include "core/mesh/cloud.h"

namespace octacut {
namespace {

// Surfaces of different objects of the same size, or of one object turned the
// wrong way, have a median distance of some 3 % of the diagonal and more;
// reconstructions that can be used one of less than 1 %.
constexpr double kLargestMedian = 0.015;
// A second solution with a median of less than this times that of the best
// fits about as well; for the same shape turned the wrong way it is ten times
// and more, and twice or so with noise of 1 % of the diagonal.
constexpr double kAmbiguous = 1.3;
// Nor do medians tell solutions apart that differ by less than this share of
// the diagonal: the search goes no further.
constexpr double kSameMedian = 2e-4;

double DiagonalOf(const std::vector<SurfaceSample>& samples) {
  Eigen::AlignedBox3d box;
  for (const SurfaceSample& sample : samples) {
    box.extend(sample.point);
  }
  return box.diagonal().norm();
}

void ReportDoubts(const MeshAlignment& alignment,
                  const AlignMeshesOptions& options,
                  double diagonal,
                  const Context& context) {
  if (alignment.median_after > kLargestMedian * diagonal) {
    const std::string problem = fmt::format(
        "the surfaces stay {:.2g} % of the diagonal apart (median), which is "
        "too much for two meshes of the same object",
        100 * alignment.median_after / diagonal);
    if (options.global_search) {
      throw InputError("alignment failed: " + problem);
    }
    context.Warn(
        fmt::format("Alignment: {}; if the meshes were not nearly aligned, use "
                    "`alignment.global_search`",
                    problem));
  } else if (!alignment.converged) {
    context.Warn(
        fmt::format("The alignment did not converge within {} iterations; the "
                    "root mean square of the distances is {:.2g} % of the "
                    "diagonal.",
                    alignment.num_iterations,
                    100 * alignment.rms_after / diagonal));
  }
  if (alignment.is_ambiguous) {
    context.Warn(
        "Alignment: another rotation fits about as well; the shape is "
        "symmetric, or the solution is not certain");
  }
}

}  // namespace

void AlignMeshesOptions::Check() const {
  CheckOption(num_samples >= 10 && num_samples <= int64_t{100'000'000},
              "alignment.num_samples",
              num_samples,
              "must be from 10 to 100000000");
}

MeshAlignment AlignMeshes(const IndexedMesh& mesh,
                          const IndexedMesh& reference,
                          const AlignMeshesOptions& options,
                          const Context& context,
                          const ReferenceFilter& filter) {
  if (mesh.triangles.empty() || reference.triangles.empty()) {
    return AlignMeshes(PointsAsTriangles(mesh),
                       PointsAsTriangles(reference),
                       options,
                       context,
                       filter);
  }
  return AlignMeshes({mesh, RayScene(mesh)},
                     {reference, RayScene(reference)},
                     options,
                     context,
                     filter);
}

MeshAlignment AlignMeshes(const MeshWithScene& mesh,
                          const MeshWithScene& reference,
                          const AlignMeshesOptions& options,
                          const Context& context,
                          const ReferenceFilter& filter) {
  options.Check();
  const SurfaceIcp icp(mesh, reference, filter, options.num_samples, context);
  MeshAlignment alignment;
  Similarity3d start;
  if (options.global_search) {
    const GlobalAlignment found = FindGlobalAlignment(
        mesh, reference, filter, options.estimate_scale, context);
    start = found.reference_from_mesh;
    alignment.is_ambiguous =
        found.next_median <
        std::max(
            kAmbiguous * found.median,
            found.median + kSameMedian * DiagonalOf(icp.ReferenceSamples()));
  }
  const Phase phase(context, "alignment");
  const IcpResult result = icp.Run(start,
                                   {AlignMeshesOptions::kMaxIterations,
                                    options.estimate_scale,
                                    AlignMeshesOptions::kTolerance},
                                   context);
  alignment.reference_from_mesh = result.reference_from_mesh;
  alignment.num_iterations = result.num_iterations;
  alignment.converged = result.converged;
  alignment.rms_before = result.before.rms;
  alignment.rms_after = result.after.rms;
  alignment.median_after = result.after.median;
  alignment.inliers = result.after.inliers;
  ReportDoubts(alignment, options, DiagonalOf(icp.ReferenceSamples()), context);
  return alignment;
}

}  // namespace octacut
