#include "plugin/mesh_json.h"

#include <Eigen/Geometry>

#include "core/benchmark/compare/distance_curve.h"
#include "plugin/transform_file.h"
#include "plugin/vector_json.h"

namespace octacut {
namespace {

void AddDistance(const char* name,
                 double distance,
                 double diagonal,
                 Json* json) {
  (*json)[name] = distance;
  (*json)[std::string(name) + "_over_diagonal"] = distance / diagonal;
}

Json DistancesToJson(const DistanceStatistics& statistics, double diagonal) {
  Json json;
  json["samples"] = statistics.num_samples;
  AddDistance("mean", statistics.mean, diagonal, &json);
  AddDistance("rms", statistics.rms, diagonal, &json);
  AddDistance("median", statistics.median, diagonal, &json);
  AddDistance("percentile_90", statistics.percentile_90, diagonal, &json);
  AddDistance("max", statistics.max, diagonal, &json);
  return json;
}

Json AlignmentToJson(const MeshAlignment& alignment, double diagonal) {
  const Similarity3d& transform = alignment.reference_from_mesh;
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row) {
    rotation.push_back(VectorToJson(transform.rotation.row(row).transpose()));
  }
  Json json;
  json["matrix"] = TransformToJson(transform);
  json["scale"] = transform.scale;
  json["rotation"] = std::move(rotation);
  json["translation"] = VectorToJson(transform.translation);
  json["iterations"] = alignment.num_iterations;
  json["converged"] = alignment.converged;
  AddDistance("rms_before", alignment.rms_before, diagonal, &json);
  AddDistance("rms_after", alignment.rms_after, diagonal, &json);
  AddDistance("median_after", alignment.median_after, diagonal, &json);
  json["inliers"] = alignment.inliers;
  json["ambiguous"] = alignment.is_ambiguous;
  return json;
}

Json CurvesToJson(const MeshComparison& comparison) {
  return {{"steps_per_decade", kCurveStepsPerDecade},
          {"decades", kCurveDecades},
          {"to", comparison.precision_curve},
          {"from", comparison.recall_curve}};
}

}  // namespace

Json AuditToJson(const MeshAudit& audit) {
  Json json;
  json["vertices"] = audit.num_vertices;
  json["triangles"] = audit.num_triangles;
  json["edges"] = audit.num_edges;
  json["closed"] = audit.IsClosed();
  json["edge_manifold"] = audit.IsEdgeManifold();
  json["vertex_manifold"] = audit.IsVertexManifold();
  json["oriented"] = audit.IsOriented();
  json["outward"] = audit.IsOutward();
  json["boundary_edges"] = audit.num_boundary_edges;
  json["nonmanifold_edges"] = audit.num_nonmanifold_edges;
  json["misoriented_edges"] = audit.num_misoriented_edges;
  json["nonmanifold_vertices"] = audit.num_nonmanifold_vertices;
  json["unreferenced_vertices"] = audit.num_unreferenced_vertices;
  json["degenerate_triangles"] = audit.num_degenerate_triangles;
  json["duplicate_triangles"] = audit.num_duplicate_triangles;
  json["nonfinite_vertices"] = audit.num_nonfinite_vertices;
  json["components"] = audit.num_components;
  json["euler_characteristic"] = audit.euler_characteristic;
  json["genus"] = audit.genus < 0 ? Json() : Json(audit.genus);
  json["area"] = audit.area;
  json["volume"] = audit.volume;
  json["bounding_box"] = audit.bounding_box.isEmpty()
                             ? Json()
                             : Json({VectorToJson(audit.bounding_box.min()),
                                     VectorToJson(audit.bounding_box.max())});
  json["failure"] = audit.DescribeFailure();
  return json;
}

Json SelfIntersectionsToJson(const SelfIntersections& found) {
  return {{"pairs", found.num_pairs},
          {"triangles", found.num_triangles},
          {"left_out", found.num_left_out}};
}

Json DistancesToJson(const MeshComparison& comparison) {
  const double diagonal = comparison.reference_diagonal;
  Json json;
  json["reference_diagonal"] = diagonal;
  json["judged_share"] = comparison.judged_share;
  if (comparison.alignment) {
    json["alignment"] = AlignmentToJson(*comparison.alignment, diagonal);
  }
  json["to_reference"] = DistancesToJson(comparison.to_reference, diagonal);
  json["from_reference"] = DistancesToJson(comparison.from_reference, diagonal);
  AddDistance("hausdorff", comparison.Hausdorff(), diagonal, &json);
  json["curves"] = CurvesToJson(comparison);
  return json;
}

Json ComparisonToJson(const MeshComparison& comparison) {
  const double diagonal = comparison.reference_diagonal;
  Json json = DistancesToJson(comparison);
  json["scores"] = Json::array();
  for (const ThresholdScore& score : comparison.scores) {
    json["scores"].push_back({{"threshold", score.threshold},
                              {"distance", score.distance},
                              {"precision", score.precision},
                              {"recall", score.recall},
                              {"f_score", score.f_score}});
  }
  AddDistance("accuracy", comparison.accuracy, diagonal, &json);
  json["completeness"] = comparison.completeness;
  if (comparison.confidence) {
    AddDistance("least_confident_tenth",
                comparison.confidence->least_confident,
                diagonal,
                &json["confidence"]);
    AddDistance("most_confident_tenth",
                comparison.confidence->most_confident,
                diagonal,
                &json["confidence"]);
    json["confidence"]["ratio"] = comparison.confidence->Ratio();
  }
  return json;
}

Json SupportToJson(const std::vector<ViewSupport>& support,
                   const std::vector<View>& views) {
  const std::vector<bool> contradicts = ContradictingViews(support);
  Json each = Json::array();
  for (size_t i = 0; i < views.size(); ++i) {
    each.push_back({{"name", views[i].name},
                    {"support", support[i].support},
                    {"textured_pixels", support[i].textured_pixels},
                    {"compared_pixels", support[i].compared_pixels},
                    {"contradicts", bool(contradicts[i])}});
  }
  return {{"mean", MeanSupport(support)}, {"views", std::move(each)}};
}

Json EvaluationToJson(const MeshEvaluation& evaluation,
                      const std::vector<View>& views) {
  const SilhouetteAgreement& silhouettes = evaluation.silhouettes;
  Json each = Json::array();
  for (size_t i = 0; i < views.size(); ++i) {
    const ViewSilhouette& view = silhouettes.views[i];
    each.push_back({{"name", views[i].name},
                    {"object_pixels", view.object_pixels},
                    {"mesh_pixels", view.mesh_pixels},
                    {"common_pixels", view.common_pixels},
                    {"outline_mean", view.outline_mean},
                    {"outline_max", view.outline_max}});
  }
  Json json;
  json["silhouettes"] = {
      {"intersection_over_union", silhouettes.intersection_over_union},
      {"missed", silhouettes.missed},
      {"excess", silhouettes.excess},
      {"outline_mean", silhouettes.outline_mean},
      {"outline_percentile_95", silhouettes.outline_percentile_95},
      {"views", std::move(each)}};
  if (evaluation.reprojection) {
    const Reprojection& reprojection = *evaluation.reprojection;
    json["reprojection"] = {
        {"pairs", reprojection.num_pairs},
        {"windows", reprojection.num_windows},
        {"mean_correlation", reprojection.mean_correlation},
        {"percentile_10", reprojection.percentile_10},
        {"plain_fraction", reprojection.plain_fraction},
        {"compared_fraction", reprojection.compared_fraction}};
  }
  if (!evaluation.view_support.empty()) {
    json["photo_support"] = SupportToJson(evaluation.view_support, views);
  }
  return json;
}

}  // namespace octacut
