// The results of mesh_comparer as tables for people.
#pragma once

#include <span>
#include <string>

#include "core/benchmark/compare/compare_meshes.h"
#include "core/mesh/audit.h"
#include "core/mesh/self_intersections.h"

namespace octacut {

struct ComparedMesh {
  std::string name;
  MeshAudit audit;
  std::optional<SelfIntersections> self_intersections;
  // None for the reference itself.
  std::optional<MeshComparison> comparison;
};

// What each mesh is: size, closed, manifold, components, genus.
std::string TopologyTable(std::span<const ComparedMesh> meshes);

// Distances both ways in per cent of the reference's diagonal. All `meshes`
// have a comparison here and below.
std::string DistanceTable(std::span<const ComparedMesh> meshes);

// Mean distances of the least and the most confident tenth of those meshes that
// have a confidence, likewise; empty when none has.
std::string ConfidenceTable(std::span<const ComparedMesh> meshes);

// Precision, recall and F-score at each threshold, accuracy, completeness, in
// per cent.
std::string ScoreTable(std::span<const ComparedMesh> meshes,
                       const CompareMeshesOptions& options);

// How each mesh was moved; empty when none was.
std::string AlignmentTable(std::span<const ComparedMesh> meshes);

}  // namespace octacut
