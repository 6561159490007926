// What photographs and masks say of a mesh, without ground truth.
#pragma once

#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/evaluate/photo_support.h"
#include "core/benchmark/evaluate/reprojection.h"
#include "core/benchmark/evaluate/silhouette_agreement.h"
#include "core/mesh/indexed_mesh.h"
#include "core/scene/scene.h"

namespace octacut {

struct EvaluateMeshOptions {
  bool photometric = true;  // false: silhouettes only, no images needed
  ReprojectionOptions reprojection;

  void Check() const;  // throws OptionError
};

struct MeshEvaluation {
  SilhouetteAgreement silhouettes;
  std::optional<Reprojection> reprojection;
  // With ReprojectionOptions::keep_maps: of the views, in their order.
  std::vector<ViewSupport> view_support;
  // Likewise of the mesh's vertices; not a number where nothing is known.
  std::vector<float> vertex_support;
};

// `mesh` in the frame of the views. Holds a depth (4 bytes) for each of their
// pixels. The same figures for any number of threads. Throws as RayScene,
// MeasureSilhouettes and MeasureReprojection do.
MeshEvaluation EvaluateMesh(const IndexedMesh& mesh,
                            const std::vector<View>& views,
                            const EvaluateMeshOptions& options,
                            const Context& context);

}  // namespace octacut
