// Which part of a reference meshes are compared with: what cameras see of it,
// and what is in a box.
#pragma once

#include <filesystem>
#include <vector>

#include "colmap_io/model/sparse_model.h"
#include "core/benchmark/compare/reference_filter.h"
#include "core/benchmark/compare/seen_reference.h"
#include "core/mesh/indexed_mesh.h"
#include "plugin/option_manager.h"

namespace octacut {

struct JudgedPartOptions {
  // Sparse models in the frame of the reference, and of the compared meshes;
  // empty: none.
  std::filesystem::path views_path;
  std::filesystem::path input_views_path;
  SeenReferenceOptions seen;
  std::vector<double> bounding_box;  // empty, or as BoundingBoxFromNumbers
  // Throws OptionError that names the option.
  void Check() const;
};

void DeclareJudgedPartOptions(OptionManager& options,
                              JudgedPartOptions* judged);

// `views` is the model in views_path. Empty where all of the reference is
// judged.
ReferenceFilter JudgedPart(const IndexedMesh& reference,
                           const SparseModel& views,
                           const JudgedPartOptions& options);

}  // namespace octacut
