#include "plugin/page/comparison_protocol.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "core/base/error.h"

namespace octacut {
namespace {

Eigen::AlignedBox3d BoxOf(const IndexedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : mesh.positions) {
    box.extend(position);
  }
  return box;
}

}  // namespace

std::vector<std::string> NamesOf(const std::vector<ComparedMesh>& meshes) {
  std::vector<std::string> names;
  for (const ComparedMesh& mesh : meshes) {
    names.push_back(mesh.name);
  }
  return names;
}

void CheckOverlap(const std::filesystem::path& path,
                  const IndexedMesh& mesh,
                  const std::filesystem::path& reference_path,
                  const IndexedMesh& reference) {
  const Eigen::AlignedBox3d box = BoxOf(reference);
  if (box.exteriorDistance(BoxOf(mesh)) > box.diagonal().norm()) {
    throw InputError(fmt::format(
        "{}: the mesh does not overlap {}: it is more than a diagonal away; is "
        "it in another frame?",
        path.string(),
        reference_path.string()));
  }
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
