#include "plugin/comparison_tables.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>
#include <vector>

#include "plugin/text_table.h"

namespace octacut {
namespace {

std::string Percent(double fraction, int digits) {
  return fmt::format("{:.{}f}", 100 * fraction, digits);
}

// "yes", or how many there are that should not be.
std::string YesOrCount(bool yes, size_t count) {
  return yes ? "yes" : fmt::format("no ({})", count);
}

}  // namespace

std::string TopologyTable(std::span<const ComparedMesh> meshes) {
  TextTable table({"topology",
                   "vertices",
                   "triangles",
                   "closed",
                   "manifold edges",
                   "manifold vertices",
                   "oriented",
                   "degenerate",
                   "parts",
                   "genus",
                   "intersecting"});
  for (const ComparedMesh& mesh : meshes) {
    const MeshAudit& audit = mesh.audit;
    table.AddRow(
        {mesh.name,
         fmt::format("{}", audit.num_vertices),
         fmt::format("{}", audit.num_triangles),
         YesOrCount(audit.IsClosed(), audit.num_boundary_edges),
         YesOrCount(audit.IsEdgeManifold(), audit.num_nonmanifold_edges),
         YesOrCount(audit.IsVertexManifold(), audit.num_nonmanifold_vertices),
         YesOrCount(audit.IsOriented(), audit.num_misoriented_edges),
         fmt::format("{}", audit.num_degenerate_triangles),
         fmt::format("{}", audit.num_components),
         audit.genus < 0 ? "-" : fmt::format("{}", audit.genus),
         mesh.self_intersections
             ? fmt::format("{}", mesh.self_intersections->num_triangles)
             : "-"});
  }
  return table.ToString();
}

std::string DistanceTable(std::span<const ComparedMesh> meshes) {
  TextTable table({"distance, % of diagonal",
                   "to ref: mean",
                   "rms",
                   "90 %",
                   "max",
                   "from ref: mean",
                   "rms",
                   "90 %",
                   "max"});
  for (const ComparedMesh& mesh : meshes) {
    std::vector<std::string> row = {mesh.name};
    for (const DistanceStatistics& side :
         {mesh.comparison->to_reference, mesh.comparison->from_reference}) {
      for (const double distance :
           {side.mean, side.rms, side.percentile_90, side.max}) {
        row.push_back(
            Percent(distance / mesh.comparison->reference_diagonal, 4));
      }
    }
    table.AddRow(std::move(row));
  }
  return table.ToString();
}

std::string ConfidenceTable(std::span<const ComparedMesh> meshes) {
  TextTable table({"confidence",
                   "least confident tenth: mean, %",
                   "most confident tenth: mean, %",
                   "ratio"});
  bool any = false;
  for (const ComparedMesh& mesh : meshes) {
    if (const auto& confidence = mesh.comparison->confidence) {
      any = true;
      const double diagonal = mesh.comparison->reference_diagonal;
      table.AddRow({mesh.name,
                    Percent(confidence->least_confident / diagonal, 4),
                    Percent(confidence->most_confident / diagonal, 4),
                    fmt::format("{:.2f}", confidence->Ratio())});
    }
  }
  return any ? table.ToString() : "";
}

std::string ScoreTable(std::span<const ComparedMesh> meshes,
                       const CompareMeshesOptions& options) {
  std::vector<std::string> heading = {"score, %"};
  for (const double threshold : options.thresholds) {
    heading.push_back(fmt::format("at {:g} %: precision", 100 * threshold));
    heading.push_back("recall");
    heading.push_back("F");
  }
  heading.push_back(
      fmt::format("accuracy of {:g} %", 100 * options.accuracy_fraction));
  heading.push_back(
      fmt::format("complete at {:g} %", 100 * options.completeness_threshold));
  TextTable table(std::move(heading));
  for (const ComparedMesh& mesh : meshes) {
    std::vector<std::string> row = {mesh.name};
    for (const ThresholdScore& score : mesh.comparison->scores) {
      row.push_back(Percent(score.precision, 2));
      row.push_back(Percent(score.recall, 2));
      row.push_back(Percent(score.f_score, 2));
    }
    row.push_back(Percent(
        mesh.comparison->accuracy / mesh.comparison->reference_diagonal, 4));
    row.push_back(Percent(mesh.comparison->completeness, 2));
    table.AddRow(std::move(row));
  }
  return table.ToString();
}

std::string AlignmentTable(std::span<const ComparedMesh> meshes) {
  TextTable table({"alignment",
                   "scale",
                   "rotation, degrees",
                   "rms before, % of diagonal",
                   "after",
                   "inliers, %",
                   "iterations"});
  bool any = false;
  for (const ComparedMesh& mesh : meshes) {
    if (!mesh.comparison->alignment) {
      continue;
    }
    any = true;
    const MeshAlignment& alignment = *mesh.comparison->alignment;
    const double diagonal = mesh.comparison->reference_diagonal;
    const Eigen::AngleAxisd turn(alignment.reference_from_mesh.rotation);
    table.AddRow({mesh.name,
                  fmt::format("{:.6f}", alignment.reference_from_mesh.scale),
                  fmt::format("{:.4f}", turn.angle() * 180 / std::numbers::pi),
                  Percent(alignment.rms_before / diagonal, 4),
                  Percent(alignment.rms_after / diagonal, 4),
                  Percent(alignment.inliers, 1),
                  fmt::format("{}{}{}",
                              alignment.num_iterations,
                              alignment.converged ? "" : " (not converged)",
                              alignment.is_ambiguous ? " (ambiguous)" : "")});
  }
  return any ? table.ToString() : "";
}

}  // namespace octacut
