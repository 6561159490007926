// How well the views agree about the surface as it is, and what to take back
// where they agree less than before.
#pragma once

#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "core/refine/seen_surface.h"
#include "core/refine/surface_points.h"

namespace octacut {

// At that scale; one element per point.
struct SurfaceAgreement {
  SurfacePoints points;
  // At least two views show the whole patch around the point.
  std::vector<uint8_t> is_measured;
  std::vector<float> scores;    // -1 .. 1, where it is measured
  std::vector<float> mattness;  // 0 .. 1, where it is measured
  // How much of the photographs shows the point: the sum of the weights of the
  // views that were chosen for it.
  std::vector<float> shown;

  // The mean around a point where nothing is measured.
  static constexpr float kUnmeasured = -2;

  // The mean of the scores weighted by `shown`, so that deep folds, which few
  // views look into, count little. Points that are not measured count as 0. 0
  // if no view shows anything.
  double Mean() const;
  // For each point, the mean score of the measured points at most three steps
  // away, itself included; kUnmeasured if there are none.
  std::vector<float> MeansAround() const;
  // The value that a tenth of the means around measured points exceed.
  // 0 where nothing is measured.
  double UpperDecile() const;
};

inline constexpr const char* kAgreementPhase =
    "refinement: agreement of the views";

// At points four samples apart. `mesh` is given normals.
SurfaceAgreement MeasureAgreement(const Look& look,
                                  const Context& context,
                                  IndexedMesh* mesh,
                                  const char* phase = kAgreementPhase);

// The shares of their moves by which vertices have moved back.
struct TakenBack {
  std::vector<float> of_vertices;
  double mean = 0;  // of those in the part that is looked at
};

// Moves vertices of `mesh` back to `positions`, where `before` was measured, or
// towards them, where the views agree less than they did there: a surface that
// is smoothed coarsely loses its narrow folds, which photographs see. What
// scatters about no change is kept (docs/experiments/refinement_folds.md). The
// mesh may intersect itself.
TakenBack TakeBackHarm(const Look& look,
                       const std::vector<Eigen::Vector3d>& positions,
                       const SurfaceAgreement& before,
                       const Context& context,
                       IndexedMesh* mesh);

// Moves vertices back in the same way, and returns the same, but wherever the
// views do not agree significantly better than at `positions`.
TakenBack KeepGains(const Look& look,
                    const std::vector<Eigen::Vector3d>& positions,
                    const SurfaceAgreement& before,
                    const Context& context,
                    IndexedMesh* mesh);

}  // namespace octacut
