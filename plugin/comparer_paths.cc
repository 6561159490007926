#include "plugin/comparer_paths.h"

#include "colmap_io/images/workspace.h"
#include "core/base/check_option.h"
#include "plugin/file_roles.h"
#include "plugin/page/comparison_page.h"

namespace octacut {

std::filesystem::path ComparerPaths::DistancesOf(
    const std::filesystem::path& input) const {
  return distance_folder / (input.stem().string() + "-distance.ply");
}

void DeclareComparerPaths(OptionManager& options, ComparerPaths* paths) {
  options.AddRequiredRepeatable("input_path",
                                &paths->inputs,
                                "Mesh or point cloud to compare (.ply, .obj, "
                                ".off or .stl), or several separated by "
                                "commas.");
  options.AddRequired("reference_path",
                      &paths->reference,
                      "Reference mesh or point cloud (for eth3d, the scans' "
                      ".mlp project).");
  options.Add(
      "output_path", &paths->report, "JSON report to write. Default: none.");
  options.Add(
      "html_path",
      &paths->page,
      "HTML page to write: a viewer for the meshes and their distances. "
      "Default: none.");
  options.Add(
      "transform_path",
      &paths->transform,
      "Text file with a 4 x 4 matrix, row by row, by which the compared "
      "meshes are moved first. Default: none.");
  options
      .Add("transform_output_path",
           &paths->transform_output,
           "Text file to write: the 4 x 4 matrix that brings the mesh, one "
           "only, into the frame of the reference. Used with "
           "align, and with protocols that align.")
      .ForExperts();
  options
      .Add("distance_path",
           &paths->distance_folder,
           "Folder in which each compared mesh is saved with its signed "
           "distance to the reference at every vertex (.ply, property quality, "
           "for MeshLab and CloudCompare). Default: none.")
      .ForExperts();
}

void CheckComparerPaths(const ComparerPaths& paths,
                        const std::vector<std::filesystem::path>& crops,
                        const std::vector<std::filesystem::path>& models,
                        bool aligns,
                        const OptionManager& options) {
  FileRoles files(options);
  for (const std::filesystem::path& path : paths.inputs) {
    files.Read(path, "a mesh to compare");
  }
  for (const std::filesystem::path& path : crops) {
    files.Read(path, "the crop");
  }
  for (const std::filesystem::path& path : models) {
    for (const std::filesystem::path& model : FindModels(path)) {
      for (const auto& file : std::filesystem::directory_iterator(model)) {
        files.Read(file.path(), "a file of a sparse model");
      }
    }
  }
  files.Read(paths.reference, "the reference");
  files.Read(paths.transform, "the transform to read");
  files.Write("output_path", paths.report, "the report");
  CheckPagePath(paths.page, &files);
  CheckOption(
      paths.transform_output.empty() || (aligns && paths.inputs.size() == 1),
      "transform_output_path",
      paths.transform_output.string(),
      "needs align = 1 or a protocol that aligns, and a single "
      "input_path");
  files.Write(
      "transform_output_path", paths.transform_output, "the transform found");
  if (!paths.distance_folder.empty()) {
    for (const std::filesystem::path& path : paths.inputs) {
      files.Write("distance_path",
                  paths.DistancesOf(path),
                  "the distances of another mesh");
    }
  }
}

}  // namespace octacut
