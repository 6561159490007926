// The sparse points of a model that lie on the object.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "colmap_io/model/sparse_model.h"
#include "core/scene/scene.h"

namespace octacut {

// Positions of the points, in the order of the model, that
// - have a reprojection error of at most four times the median error (points
//   whose error is not known pass),
// - are seen in at least three images, or two when the model has tracks no
//   longer than that,
// - lie inside the masks of at least two images that see them, and of four in
//   five: a point of the background may be behind the object in images that do
//   not see it,
// - lie inside the masks of four in five of all views (PointsInsideMasks).
// `views` are of images of the model, found by their names; their masks may be
// of low resolution.
std::vector<Eigen::Vector3d> ScenePoints(const SparseModel& model,
                                         const std::vector<View>& views);

}  // namespace octacut
