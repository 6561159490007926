#include "plugin/workspace_options.h"

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/base/check_option.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

Json VectorToJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

void DeclareLoadingOptions(OptionManager& options,
                           fs::path* workspace_path,
                           LoadSceneOptions* loading) {
  options.AddRequired("workspace_path",
                      workspace_path,
                      "COLMAP project (images, sparse) or dense folder");
  options.Add("image_path",
              &loading->workspace.image_path,
              "Folder of the photographs; default: images in the workspace");
  options.Add("input_path",
              &loading->workspace.input_path,
              "Folder of the sparse model; default: the one in the workspace "
              "with most images");
  options.Add("mask_path",
              &loading->workspace.mask_path,
              "Folder of the silhouettes; default: masks in the workspace");
  options.AddEnum("mask_geometry",
                  &loading->mask_geometry,
                  {{"auto", MaskGeometry::kAuto},
                   {"original", MaskGeometry::kOriginal},
                   {"undistorted", MaskGeometry::kUndistorted}},
                  "Geometry of the masks: found from their size, that of the "
                  "original photographs, or that of image_undistorter's");
  options.Add("original_path",
              &loading->original_path,
              "Model of the original photographs, for a dense folder whose "
              "masks are in their geometry");
  options.Add("image_list_path",
              &loading->workspace.image_list_path,
              "Text file with the names of the images to use, one a line; "
              "default: all of the model");
  options.Add("skip_missing_images",
              &loading->skip_missing_images,
              "1: go on without images whose file is missing");
  options.Add(
      "skip_missing_masks",
      &loading->skip_missing_masks,
      "1: go on without images whose mask is missing, all background or "
      "all object");
}

void DeclareMaskTolerance(OptionManager& options, double* mask_tolerance) {
  options.Add("OctahedralMeshing.mask_tolerance",
              mask_tolerance,
              "Pixels of the photographs by which masks may be cut too close");
}

void DeclareFillFalseGaps(OptionManager& options, bool* fill_false_gaps) {
  options.Add(
      "OctahedralMeshing.fill_false_gaps",
      fill_false_gaps,
      "1: holes and bays of masks are filled where other views show the "
      "object");
}

void WorkspaceArguments::Declare(OptionManager& options) {
  DeclareLoadingOptions(options, &workspace_path, &loading);
  options.Add("keep_all_views",
              &loading.keep_all_views,
              "1: believes views whose mask or pose contradicts the others', "
              "instead of leaving them out");
  options.Add("output_path",
              &output_path,
              "Mesh to write (.ply, .obj, .off, .stl); default: in the "
              "workspace");
  options.Add("report_path",
              &report_path,
              "JSON report; default: beside the mesh, with .json");
  options.Add("OctahedralMeshing.bounding_box",
              &bounding_box,
              "x0,y0,z0,x1,y1,z1 of the object; default: from the silhouettes");
}

void WorkspaceArguments::DeclareConfidence(OptionManager& options) {
  options.Add("confidence",
              &confidence,
              "1: the mesh (.ply) has a float confidence for each vertex, 0 .. "
              "1: 1 / (1 + pixels by which it may lie elsewhere)");
}

void WorkspaceArguments::Complete(const fs::path& default_output) {
  loading.Check();
  if (!bounding_box.empty()) {
    loading.region.bounding_box = BoundingBoxFromNumbers(bounding_box);
  }
  if (!fs::is_directory(workspace_path)) {
    throw InputError(workspace_path.string() + ": no such workspace folder");
  }
  if (output_path.empty()) {
    output_path = workspace_path / default_output;
  }
  if (report_path.empty()) {
    report_path = Beside(".json");
  }
  CheckMeshPath(output_path);
  CheckOption(!confidence || MeshFormatOf(output_path) == MeshFormat::kPly,
              "confidence",
              confidence,
              "needs an output_path that ends in .ply");
  // The report is written last; that it cannot be must not be news then.
  CheckReportIsNot(output_path, "the mesh");
  CheckFilePath(report_path);
}

void WorkspaceArguments::CheckReportIsNot(const fs::path& other,
                                          const std::string& what) const {
  std::error_code ignored;
  CheckOption(fs::weakly_canonical(report_path, ignored) !=
                  fs::weakly_canonical(other, ignored),
              "report_path",
              report_path.string(),
              "must be another file than " + what);
}

fs::path WorkspaceArguments::Beside(const std::string& ending) const {
  fs::path path = output_path;
  path.replace_extension();
  path += ending;
  return path;
}

namespace {

Json BadViewsToJson(const BadViewSummary& summary) {
  Json views = Json::array();
  for (const BadView& view : summary.views) {
    views.push_back({{"name", view.name},
                     {"mask", view.mask_file.string()},
                     {"unexplained", view.fit.unexplained},
                     {"taken", view.fit.taken},
                     {"left_out", view.is_left_out}});
  }
  return {{"judged", summary.is_judged},
          {"views", views},
          {"largest_unexplained_of_others", summary.largest_left.unexplained},
          {"largest_taken_by_others", summary.largest_left.taken},
          {"seconds", summary.seconds}};
}

}  // namespace

Json LoadSummaryToJson(const LoadSceneSummary& summary, const Region& region) {
  return {{"image_path", summary.image_path.string()},
          {"model_path", summary.model_path.string()},
          {"mask_path", summary.mask_path.string()},
          {"registered_images", summary.num_images},
          {"views", summary.num_views},
          {"missing_images", summary.num_missing_images},
          {"missing_masks", summary.num_missing_masks},
          {"masks_without_outline", summary.num_masks_without_outline},
          {"contradicting_views", BadViewsToJson(summary.bad_views)},
          {"filled_mask_bites", summary.num_filled_bites},
          {"views_elsewhere", summary.num_views_elsewhere},
          {"sparse_points", summary.num_points},
          {"pixel_bytes", summary.scene_bytes},
          {"mask_seconds", summary.mask_seconds},
          {"region_seconds", summary.region_seconds},
          {"image_seconds", summary.image_seconds},
          {"region",
           {{"source", ToString(region.source)},
            {"box_min", VectorToJson(region.box.min())},
            {"box_max", VectorToJson(region.box.max())},
            {"cube_min", VectorToJson(region.cube.min_corner)},
            {"cube_edge", region.cube.edge}}}};
}

}  // namespace octacut
