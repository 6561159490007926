#include "plugin/page/comparison_procedure.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "core/base/error.h"
#include "core/mesh/bounding_box.h"

namespace octacut {
namespace {

// In diagonals of the reference: a scan of one side of an object and its mesh
// may lie beside each other by as much.
constexpr double kMostApart = 0.2;

}  // namespace

void CheckOverlap(const std::filesystem::path& path,
                  const IndexedMesh& mesh,
                  const std::filesystem::path& reference_path,
                  const IndexedMesh& reference) {
  const Eigen::AlignedBox3d box = BoundingBox(reference);
  if (!(box.diagonal().norm() > 0)) {
    throw InputError(fmt::format("{}: all points lie in one place",
                                 reference_path.string()));
  }
  const double gap = box.exteriorDistance(BoundingBox(mesh));
  const double diagonal = box.diagonal().norm();
  if (gap > kMostApart * diagonal) {
    throw InputError(fmt::format(
        "{}: the mesh does not overlap {}: their bounding boxes are {:.3g} "
        "apart, {:.0f} % of the diagonal; is it in another frame?",
        path.string(),
        reference_path.string(),
        gap,
        100 * gap / diagonal));
  }
}

std::string SamplingLine(int64_t num_samples) {
  return fmt::format(
      "Sampling: {} points on each surface, spread evenly by area; distances "
      "to the closest point of the other surface. Maxima include vertices.",
      num_samples);
}

std::string SignsLine() {
  return "Signs: positive is outside of the other surface, by the orientation "
         "of its triangles; distances to point clouds have no sign. Coloured "
         "values are those of the full mesh's vertices.";
}

std::string AlignmentLine(const std::string& name,
                          const MeshAlignment& alignment,
                          const AlignMeshesOptions& options,
                          double diagonal) {
  return fmt::format(
      "Alignment: {} was registered with the reference ({}ICP, {}, Tukey's "
      "loss at 4.685 standard deviations, {:.1f} % of the pairs not "
      "rejected): root mean square {:.4g} % of the diagonal before, {:.4g} "
      "% after {} iterations{}{}.",
      name,
      options.global_search ? "global search, then " : "",
      options.estimate_scale ? "similarity" : "rigid",
      100 * alignment.inliers,
      100 * alignment.rms_before / diagonal,
      100 * alignment.rms_after / diagonal,
      alignment.num_iterations,
      alignment.converged ? "" : ", not converged",
      alignment.is_ambiguous ? "; another rotation fits about as well" : "");
}

std::string CropLine(const CropOfReference& crop) {
  if (crop.is_whole_box && crop.views_path.empty()) {
    return "Crop: none, all of the reference counts.";
  }
  std::string line = "Crop: ";
  if (!crop.is_whole_box) {
    line += "inside the bounding box; ";
  }
  if (!crop.views_path.empty()) {
    line += fmt::format(
        "where at least {} cameras of {} see the reference at {:g} degrees or "
        "less to its normal; ",
        crop.seen.min_views,
        crop.views_path,
        crop.seen.max_angle);
  }
  return line + fmt::format("{:.1f} % of the reference's area counts.",
                            100 * crop.judged_share);
}

}  // namespace octacut
