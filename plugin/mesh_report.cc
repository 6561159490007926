#include "plugin/mesh_report.h"

#include <fmt/format.h>

#include <string>

#include "plugin/mesh_json.h"
#include "plugin/report.h"
#include "plugin/verdict_json.h"
#include "plugin/verdict_text.h"

namespace octacut {
namespace {

std::string FilesWritten(const WorkspaceArguments& workspace) {
  std::string text =
      fmt::format("Wrote the report to {}", workspace.report_path.string());
  for (const auto& [path, what] : workspace.FilesBesideMesh()) {
    text += fmt::format(", {} to {}", what, path.string());
  }
  return text;
}

std::string ResourcesUsed(const Json& report) {
  std::string text =
      fmt::format("The run took {:.1f} s", report["seconds"].get<double>());
  const double bytes = report["peak_memory_bytes"].get<double>();
  // Not every system tells it.
  if (bytes > 0) {
    text += fmt::format(" and at most {:.2f} GB of memory", bytes / 1e9);
  }
  return text + ".";
}

}  // namespace

void WriteMeshReport(const CommandEnvironment& environment,
                     const WorkspaceArguments& workspace,
                     const MeshResult& result,
                     AtomicFiles* files) {
  const std::vector<View>& views = result.loaded.scene.views;
  const VerdictText words = DescribeVerdict(result.verdict, views);
  ReportVerdict(words, environment.context);

  Json report = MakeReport(environment);
  report["mesh_path"] = workspace.output_path.string();
  report["input"] =
      LoadSummaryToJson(result.loaded.summary, result.loaded.region);
  report["audit"] = AuditToJson(result.audit);
  report["verdict"] = VerdictToJson(result.verdict, words, views);
  report.update(result.own_members);
  WriteReport(workspace.report_path, report, files);
  files->Commit();
  environment.context.Info(FilesWritten(workspace));
  environment.context.Info(ResourcesUsed(report));
}

void PrintMesh(const CommandEnvironment& environment,
               const WorkspaceArguments& workspace,
               const MeshAudit& audit) {
  environment.out << fmt::format(
      "{}: {} vertices, {} triangles, closed 2-manifold with {} {}, genus {}\n",
      workspace.output_path.string(),
      audit.num_vertices,
      audit.num_triangles,
      audit.num_components,
      audit.num_components == 1 ? "component" : "components",
      audit.genus);
}

}  // namespace octacut
