// One HTML file in which a person looks at meshes and at what was measured of
// them. It needs no network: the meshes, photographs, the report, three.js and
// the scripts of plugin/page/web are inside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_io/files/atomic_files.h"
#include "core/base/context.h"
#include "core/scene/scene.h"
#include "plugin/file_roles.h"
#include "plugin/option_value.h"
#include "plugin/page/page_mesh.h"

namespace octacut {

// clang-tidy does not see that moving a Json cannot fail.
// NOLINTNEXTLINE(bugprone-exception-escape)
struct ComparisonPage {
  std::string title;
  // Whether one of the meshes counts as the truth: only then are distances
  // called errors and are there scores.
  bool has_truth = false;
  // Unit of relative distances: the diagonal of the reference, or of the first
  // mesh where there is none.
  double diagonal = 0;
  std::string compared_with;  // the name of that mesh
  // Where the views are taken from, to show the meshes upright at first.
  std::vector<Rigid3d> cameras;
  // In the order of the report; the reference last.
  std::vector<PageMesh> meshes;
  // Lines that state how the figures came about.
  std::vector<std::string> procedure;
  std::string command_line;
  Json report;
};

// Where Debian's package libjs-three keeps three.js.
std::filesystem::path ThreeJsPath();

// To be asked before any long work: throws InputError when the page cannot be
// written or `three_js` is missing, and OptionError when `html_path` is one of
// `files`, which it joins, or does not end with .html or .htm. An empty
// html_path is no page.
void CheckPagePath(const std::filesystem::path& html_path,
                   FileRoles* files,
                   const std::filesystem::path& three_js = ThreeJsPath());

// `photographs` may be empty. The file appears when `files` are committed.
void WriteComparisonPage(const std::filesystem::path& html_path,
                         const ComparisonPage& page,
                         const std::vector<View>& photographs,
                         const Context& context,
                         AtomicFiles* files);

}  // namespace octacut
