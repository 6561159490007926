// The options that say where a workspace's parts are, shared by the commands
// that read one.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "colmap_io/images/load_scene.h"
#include "plugin/file_roles.h"
#include "plugin/option_manager.h"

namespace octacut {

// Where images, model and masks are, and what to do without some images.
void DeclareImageOptions(OptionManager& options,
                         std::filesystem::path* workspace_path,
                         LoadSceneOptions* loading);
// The same for the commands that need masks, and what to do without some.
void DeclareLoadingOptions(OptionManager& options,
                           std::filesystem::path* workspace_path,
                           LoadSceneOptions* loading);

// `bounding_box` is what OptionalBoundingBox takes.
void DeclareBoundingBox(OptionManager& options,
                        std::vector<double>* bounding_box);
void DeclareKeepAllViews(OptionManager& options, bool* keep_all_views);

// The tolerance for errors of the masks; for the commands that use it.
void DeclareMaskTolerance(OptionManager& options, double* mask_tolerance);
void DeclareFillFalseGaps(OptionManager& options, bool* fill_false_gaps);
void DeclareMoveMaskBorders(OptionManager& options, bool* move_mask_borders);

struct WorkspaceArguments {
  std::filesystem::path workspace_path;
  std::filesystem::path output_path;  // empty: the default in the workspace
  std::filesystem::path report_path;  // empty: output_path with .json
  LoadSceneOptions loading;
  std::vector<double> bounding_box;  // empty, or x0,y0,z0,x1,y1,z1
  bool confidence = false;           // of the vertices, in the mesh

  // `default_output` is the name of the mesh in the workspace.
  void Declare(const std::string& default_output, OptionManager& options);
  // For the commands that compare photographs.
  void DeclareConfidence(OptionManager& options);
  // A file beside the mesh that a command writes: what it ends with, and what
  // it is.
  struct FileBeside {
    std::string ending;
    std::string what;
  };
  // Fills in the defaults and checks that mesh, files beside it and report can
  // be written and replace none of each other and of `files`, which the command
  // reads; to be asked before any long work.
  void Complete(const std::vector<FileBeside>& beside, FileRoles files);
  // The output path with another ending, for files beside the mesh.
  std::filesystem::path Beside(const std::string& ending) const;
  // Those given to Complete that are not the mesh itself: path, what it is.
  std::vector<std::pair<std::filesystem::path, std::string>> FilesBesideMesh()
      const;

 private:
  std::string default_output_;
  std::vector<FileBeside> beside_;
};

// What was read, for the report.
Json LoadSummaryToJson(const LoadSceneSummary& summary, const Region& region);

}  // namespace octacut
