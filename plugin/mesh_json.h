// Measurements of meshes as members of a report.
#pragma once

#include "core/benchmark/compare/compare_meshes.h"
#include "core/benchmark/evaluate/evaluate_mesh.h"
#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"
#include "plugin/option_value.h"

namespace octacut {

// {"vertices", "triangles", ..., "closed", "edge_manifold",
//  "vertex_manifold", "oriented", "outward", "components", "genus" (null
//  unless closed, manifold and oriented), "area", "volume",
//  "bounding_box": [[x, y, z], [x, y, z]], "failure"}
Json AuditToJson(const MeshAudit& audit);

// {"pairs", "triangles", "left_out"}
Json SelfIntersectionsToJson(const SelfIntersections& found);

// Distances in the reference's units, and as fractions of its diagonal in
// members "..._over_diagonal".
Json ComparisonToJson(const MeshComparison& comparison);

// The same without scores, for meshes of which none counts as correct.
Json DistancesToJson(const MeshComparison& comparison);

// {"mean", "views": [{"name", "support", "textured_pixels", "compared_pixels",
//  "contradicts"}, ...]}
Json SupportToJson(const std::vector<ViewSupport>& support,
                   const std::vector<View>& views);

// {"silhouettes": {"intersection_over_union", "missed", "excess",
//  "outline_mean", "outline_percentile_95", "views": [...]}, "reprojection"
//  where it was measured: {"pairs", "windows", "mean_correlation",
//  "percentile_10", "plain_fraction", "compared_fraction"}, "photo_support"
//  likewise}; the views in the order of `views`, named.
Json EvaluationToJson(const MeshEvaluation& evaluation,
                      const std::vector<View>& views);

}  // namespace octacut
