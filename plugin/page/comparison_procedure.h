// How meshes were compared, in lines for the page, and checks of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/benchmark/compare/align_meshes.h"
#include "core/benchmark/compare/seen_reference.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

// Distances between meshes of different frames mean nothing: throws InputError
// when the boxes are more than a fifth of the reference's diagonal apart, or
// when the reference has no size.
void CheckOverlap(const std::filesystem::path& path,
                  const IndexedMesh& mesh,
                  const std::filesystem::path& reference_path,
                  const IndexedMesh& reference);

std::string SamplingLine(int64_t num_samples);
std::string SignsLine();

// How a mesh was registered, with what remains.
std::string AlignmentLine(const std::string& name,
                          const MeshAlignment& alignment,
                          const AlignMeshesOptions& options,
                          double diagonal);

// Which part of a reference counts.
struct CropOfReference {
  bool is_whole_box = true;  // no bounding box
  std::string views_path;    // empty: no cameras
  SeenReferenceOptions seen;
  double judged_share = 1;
};

std::string CropLine(const CropOfReference& crop);

}  // namespace octacut
