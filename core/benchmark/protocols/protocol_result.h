// What a benchmark's protocol measures of one mesh.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/similarity.h"

namespace octacut {

enum class FigureKind { kDistance, kFraction, kCount };

// A figure by the name that the benchmark uses. Distances are in the
// reference's units, fractions between 0 and 1.
struct ProtocolFigure {
  std::string name;
  double value = 0;
  FigureKind kind = FigureKind::kDistance;
};

// What lies within a distance: precision (accuracy in ETH3D) of the mesh and
// recall (completeness) of the reference, and their harmonic mean, 0 where
// both are 0.
struct ProtocolScore {
  double tolerance = 0;  // in the reference's units
  double precision = 0;
  double recall = 0;
  double f_score = 0;
};

struct ProtocolResult {
  std::vector<ProtocolFigure> figures;
  std::vector<ProtocolScore> scores;
  // How the mesh was moved, where the protocol aligns it.
  std::optional<Similarity3d> reference_from_mesh;
};

inline ProtocolScore MakeScore(double tolerance,
                               double precision,
                               double recall) {
  const double sum = precision + recall;
  return {
      tolerance, precision, recall, sum > 0 ? 2 * precision * recall / sum : 0};
}

}  // namespace octacut
