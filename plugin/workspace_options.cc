#include "plugin/workspace_options.h"

#include "colmap_io/files/require_folder.h"
#include "colmap_io/mesh/mesh_io.h"
#include "core/base/check_option.h"
#include "plugin/vector_json.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

}  // namespace

void DeclareImageOptions(OptionManager& options,
                         fs::path* workspace_path,
                         LoadSceneOptions* loading) {
  options.AddRequired("workspace_path",
                      workspace_path,
                      "Folder of the COLMAP project (with images, masks and "
                      "sparse) or a dense folder.");
  options.Add("image_path",
              &loading->workspace.image_path,
              "Folder of the photographs. Default: images in the workspace.");
  options.Add("input_path",
              &loading->workspace.input_path,
              "Folder of the sparse model. Default: the model in the workspace "
              "that has the most images.");
  options.Add(
      "mask_path",
      &loading->workspace.mask_path,
      "Folder of the silhouette masks. Default: masks in the workspace.");
  options
      .AddEnum("mask_geometry",
               &loading->mask_geometry,
               {{"auto", MaskGeometry::kAuto},
                {"original", MaskGeometry::kOriginal},
                {"undistorted", MaskGeometry::kUndistorted}},
               "Whether the masks fit the original photographs or the "
               "undistorted images; auto decides by their size.")
      .ForExperts();
  options
      .Add("original_path",
           &loading->original_path,
           "Folder of the sparse model of the original photographs, for a "
           "dense folder whose masks fit these.")
      .ForExperts();
  options
      .Add("image_list_path",
           &loading->workspace.image_list_path,
           "Text file with the names of the images to use, one per line. "
           "Default: all images of the model.")
      .ForExperts();
  options
      .Add("skip_missing_images",
           &loading->skip_missing_images,
           "If 1, leave out images whose file is missing instead of stopping.")
      .ForExperts();
}

void DeclareLoadingOptions(OptionManager& options,
                           fs::path* workspace_path,
                           LoadSceneOptions* loading) {
  DeclareImageOptions(options, workspace_path, loading);
  options.Add(
      "skip_missing_masks",
      &loading->skip_missing_masks,
      "If 1, leave out images whose mask is missing, all background, or "
      "all object; if 0, stop. Images for which mask_extractor found "
      "no reliable mask, as masks.json says, are always left out.");
}

void DeclareMaskTolerance(OptionManager& options, double* mask_tolerance) {
  options.Add("OctahedralMeshing.mask_tolerance",
              mask_tolerance,
              "Number of pixels of the photographs by which masks may be too "
              "small; 0 if they are exact.");
}

void DeclareFillFalseGaps(OptionManager& options, bool* fill_false_gaps) {
  options
      .Add("OctahedralMeshing.fill_false_gaps",
           fill_false_gaps,
           "If 1, fill holes and notches of a mask where the other views or "
           "sparse points show the object.")
      .ForExperts();
}

void DeclareMoveMaskBorders(OptionManager& options, bool* move_mask_borders) {
  options
      .Add("OctahedralMeshing.move_mask_borders",
           move_mask_borders,
           "If 1, estimate from the photographs by how many pixels all masks "
           "are too large or too small, and allow for it; 0 leaves the borders "
           "of the masks where they are.")
      .ForExperts();
}

void DeclareBoundingBox(OptionManager& options,
                        std::vector<double>* bounding_box) {
  options.Add("OctahedralMeshing.bounding_box",
              bounding_box,
              "Bounding box x0,y0,z0,x1,y1,z1 of the object in the frame of "
              "the sparse model. Default: estimated from the silhouettes.");
}

void DeclareKeepAllViews(OptionManager& options, bool* keep_all_views) {
  options
      .Add("keep_all_views",
           keep_all_views,
           "If 1, use views whose mask or pose contradicts the other views "
           "instead of leaving them out.")
      .ForExperts();
}

void WorkspaceArguments::Declare(const std::string& default_output,
                                 OptionManager& options) {
  default_output_ = default_output;
  DeclareLoadingOptions(options, &workspace_path, &loading);
  DeclareKeepAllViews(options, &loading.keep_all_views);
  options.Add("output_path",
              &output_path,
              "Mesh file to write (.ply, .obj, .off, .stl or .glb). Default: " +
                  default_output + " in the workspace.");
  options
      .Add("report_path",
           &report_path,
           "JSON report to write. Default: the path of the mesh with the "
           "extension .json.")
      .ForExperts();
  DeclareBoundingBox(options, &bounding_box);
}

void WorkspaceArguments::DeclareConfidence(OptionManager& options) {
  options
      .Add(
          "confidence",
          &confidence,
          "If 1, write a confidence between 0 and 1 for each vertex (.ply "
          "only): 1 "
          "/ (1 + e), where e is the expected error of its position in pixels.")
      .ForExperts();
}

void WorkspaceArguments::Complete(const std::vector<FileBeside>& beside,
                                  FileRoles files) {
  loading.Check();
  loading.region.bounding_box = OptionalBoundingBox(bounding_box);
  RequireFolder(workspace_path, "workspace_path");
  if (output_path.empty()) {
    output_path = workspace_path / default_output_;
  }
  if (report_path.empty()) {
    report_path = Beside(".json");
  }
  CheckMeshPath(output_path);
  CheckOption(MeshFormatOf(output_path) != MeshFormat::k3mf,
              "output_path",
              output_path.string(),
              "must not be a .3mf file, whose units are millimetres; "
              "mesh_exporter writes those");
  CheckOption(!confidence || MeshFormatOf(output_path) == MeshFormat::kPly,
              "confidence",
              confidence,
              "requires an output_path with the extension .ply");
  // The report is written last, so whether it can be is checked now.
  files.Write("output_path", output_path, "the mesh");
  beside_ = beside;
  for (const auto& [path, what] : FilesBesideMesh()) {
    files.Write("output_path", path, what);
  }
  files.Write("report_path", report_path, "the report");
  files.Guard(&loading.workspace);
}

fs::path WorkspaceArguments::Beside(const std::string& ending) const {
  fs::path path = output_path;
  path.replace_extension();
  path += ending;
  return path;
}

std::vector<std::pair<fs::path, std::string>>
WorkspaceArguments::FilesBesideMesh() const {
  std::vector<std::pair<fs::path, std::string>> files;
  for (const FileBeside& file : beside_) {
    if (Beside(file.ending) != output_path) {
      files.emplace_back(Beside(file.ending), file.what);
    }
  }
  return files;
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
