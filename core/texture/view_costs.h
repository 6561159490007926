// What it costs to texture a triangle from a photograph: the data term of the
// choice of views, and the colour on which the photographs agree.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/texture/face_views.h"
#include "core/texture/photographs.h"

namespace octacut {

struct ViewCosts {
  // Blue, green, red: the median over the views of each triangle after their
  // exposures were made equal; zero for triangles that no view shows.
  std::vector<Eigen::Vector3f> consensus;
  // The cost of each triangle in each of its views (`FaceViews::Of`), 0 for the
  // best one that agrees with the others: the share of resolution that is lost
  // relative to the best view, plus up to 1 for a colour that the others do not
  // confirm, such as that of a highlight or of a passer-by.
  std::vector<std::array<float, FaceViews::kMaxViews>> costs;
  // Pixels per unit of length in the best view of each triangle; 0 for none.
  std::vector<float> resolution;
  // For each view: factors of exposure (blue, green, red).
  std::vector<Eigen::Vector3f> gains;
};

// Blurred parts of a photograph count as less resolution: contrasts are
// compared with those of other views of the same triangles.
ViewCosts ComputeViewCosts(const IndexedMesh& mesh,
                           const FaceViews& views,
                           const std::vector<PhotographPose>& poses,
                           const Context& context);

}  // namespace octacut
