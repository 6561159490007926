#include "plugin/page/distance_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "core/benchmark/compare/signed_distance.h"
#include "core/mesh/cloud.h"
#include "core/raycast/ray_scene.h"
#include "plugin/page/page_builder.h"

namespace octacut {

DistancePage::DistancePage(std::string reference_name,
                           const IndexedMesh& reference,
                           size_t num_compared,
                           const Context& context)
    : reference_name_(std::move(reference_name)),
      reference_(reference),
      num_compared_(num_compared),
      reference_page_(
          MakePageMesh(reference_name_, reference, num_compared + 1, context)) {
  reference_page_.is_reference = true;
}

Json DistancePage::Add(const std::string& name,
                       const IndexedMesh& mesh,
                       const std::vector<float>& distances,
                       double reference_diagonal,
                       const ReferenceFilter& filter,
                       const Context& context) {
  PageMesh page = MakePageMesh(name, mesh, num_compared_ + 1, context);
  FindDistancePlaces(mesh, distances, reference_diagonal, context, &page);
  AddDistances(reference_name_, distances, &page);
  if (page_.meshes.empty()) {
    const IndexedMesh surface = PointsAsTriangles(mesh);
    std::vector<float> back = SignedDistances(
        reference_.positions, surface, RayScene(surface), context);
    DropUnjudged(PointsAsTriangles(reference_), filter, &back);
    AddDistances(name, std::move(back), &reference_page_);
  }
  page_.diagonal = reference_diagonal;
  page_.meshes.push_back(std::move(page));
  const PageMesh& added = page_.meshes.back();
  return PlacesToJson(added.places, added.place_kind);
}

ComparisonPage DistancePage::Take(bool reference_is_truth) {
  std::vector<std::string> names;
  names.reserve(page_.meshes.size());
  for (const PageMesh& mesh : page_.meshes) {
    names.push_back(mesh.name);
  }
  page_.title = fmt::format("{} and {}{}",
                            fmt::join(names, ", "),
                            reference_name_,
                            reference_is_truth ? " (truth)" : "");
  page_.has_truth = reference_is_truth;
  page_.compared_with = reference_name_;
  page_.meshes.push_back(std::move(reference_page_));
  return std::move(page_);
}

}  // namespace octacut
