// The page of mesh_comparer: meshes with their distances from a reference.
#pragma once

#include <string>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/compare/reference_filter.h"
#include "core/mesh/indexed_mesh.h"
#include "plugin/option_value.h"
#include "plugin/page/comparison_page.h"

namespace octacut {

class DistancePage {
 public:
  // `num_compared` meshes are to be added. `reference` must outlive the page.
  DistancePage(std::string reference_name,
               const IndexedMesh& reference,
               size_t num_compared,
               const Context& context);

  // Adds a compared mesh, in the frame of the reference, with the signed
  // distances of its vertices, and returns the places of the largest ones as
  // PlacesToJson has them. The reference shows its own distances from the first
  // mesh, where they count by `filter`.
  Json Add(const std::string& name,
           const IndexedMesh& mesh,
           const std::vector<float>& distances,
           double reference_diagonal,
           const ReferenceFilter& filter,
           const Context& context);

  // The page with its meshes and title; all of it is moved out.
  ComparisonPage Take(bool reference_is_truth);

 private:
  std::string reference_name_;
  const IndexedMesh& reference_;
  size_t num_compared_;
  PageMesh reference_page_;
  ComparisonPage page_;
};

}  // namespace octacut
