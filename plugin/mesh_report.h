// How a command that makes a mesh from a workspace ends: with the verdict, the
// report, and what the run took.
#pragma once

#include "colmap_io/files/atomic_files.h"
#include "colmap_io/images/load_scene.h"
#include "core/mesh/audit.h"
#include "core/verdict/judge_mesh.h"
#include "plugin/command.h"
#include "plugin/workspace_options.h"

namespace octacut {

// What the report says of the mesh that has been written.
struct MeshResult {
  const LoadedScene& loaded;
  const MeshAudit& audit;
  const MeshVerdict& verdict;
  // Members of the report that only this command has.
  Json own_members = Json::object();
};

// Logs the verdict, writes the report to workspace.report_path, commits it and
// all others of `files`, and logs which files there are beside the mesh, how
// long the run took, and its peak memory. Throws InputError.
void WriteMeshReport(const CommandEnvironment& environment,
                     const WorkspaceArguments& workspace,
                     const MeshResult& result,
                     AtomicFiles* files);

// Writes one line about the new mesh to the output of the command.
void PrintMesh(const CommandEnvironment& environment,
               const WorkspaceArguments& workspace,
               const MeshAudit& audit);

}  // namespace octacut
