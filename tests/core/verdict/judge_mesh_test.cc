#include "core/verdict/judge_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/verdict/removed_parts.h"
#include "core/views/mask_shifts.h"
#include "tests/core/verdict/sphere_views.h"

namespace octacut {
namespace {

using testing::MakeSphereViews;
using testing::SphereViews;

MeshVerdict Judge(const SphereViews& sphere,
                  const IndexedMesh& mesh,
                  const IndexedMesh& removed = IndexedMesh(),
                  const JudgeOptions& options = JudgeOptions()) {
  return JudgeMesh(mesh,
                   removed,
                   {sphere.given,
                    sphere.test.scene.views,
                    sphere.test.views,
                    sphere.test.region.cube},
                   options,
                   Context(2));
}

size_t Sum(const std::vector<size_t>& values) {
  return std::accumulate(values.begin(), values.end(), size_t{0});
}

TEST(JudgeMesh, CountsPixelsThatRemovedPartsWouldCover) {
  const SphereViews sphere = MakeSphereViews();
  // As if a shell around the mesh had been removed; one far inside is no loss.
  const MeshVerdict shell = Judge(sphere, sphere.Ball(0.8), sphere.Ball(1));
  EXPECT_GT(Sum(shell.removed_pixels),
            shell.repaired_masks.total.missed * 9 / 10);
  EXPECT_LE(Sum(shell.removed_pixels), shell.repaired_masks.total.missed);
  EXPECT_EQ(
      Sum(Judge(sphere, sphere.Ball(0.8), sphere.Ball(0.5)).removed_pixels),
      0u);
  EXPECT_EQ(Sum(Judge(sphere, sphere.Ball(0.8)).removed_pixels), 0u);
}

TEST(JudgeMesh, MasksThatAreTooLargeExcuseASmallerMesh) {
  const SphereViews sphere = MakeSphereViews();
  const double pixel = sphere.test.PixelSize() / SphereViews::kRadius;
  const IndexedMesh mesh = sphere.Ball(1 - 3 * pixel);
  EXPECT_GT(Judge(sphere, mesh).repaired_masks.total.missed, 1000u);
  const MeshVerdict excused =
      Judge(sphere, mesh, IndexedMesh(), {.border_shift = 3});
  EXPECT_EQ(excused.repaired_masks.total.missed, 0u);
  EXPECT_GT(excused.repaired_masks.total.unsure, 1000u);
}

TEST(JudgeMesh, GivenMasksAreExcusedByWhatTheirBordersWereMoved) {
  SphereViews sphere = MakeSphereViews();
  std::vector<View>& given = sphere.given;
  for (View& view : given) {
    view.mask = MoveBorderInside(Silhouette(view.mask), view.mask.size(), -4);
  }
  const MeshVerdict unknown = Judge(sphere, sphere.Ball(1));
  EXPECT_GT(unknown.given_masks.total.missed, 1000u);
  EXPECT_EQ(unknown.repaired_masks.total.missed, 0u);
  const MeshVerdict excused =
      Judge(sphere,
            sphere.Ball(1),
            IndexedMesh(),
            {.moved_inwards = std::vector<double>(given.size(), 4)});
  EXPECT_EQ(excused.given_masks.total.missed, 0u);
  EXPECT_EQ(excused.repaired_masks.total.border,
            unknown.repaired_masks.total.border);
}

TEST(JudgeMesh, MasksThatMayBeTooSmallExcuseALargerMesh) {
  const SphereViews sphere = MakeSphereViews();
  const double pixel = sphere.test.PixelSize() / SphereViews::kRadius;
  const IndexedMesh mesh = sphere.Ball(1 + 3 * pixel);
  EXPECT_GT(Judge(sphere, mesh).repaired_masks.total.surely_exceeded, 1000u);
  const MeshVerdict excused =
      Judge(sphere, mesh, IndexedMesh(), {.mask_tolerance = 3});
  EXPECT_EQ(excused.repaired_masks.total.surely_exceeded, 0u);
  EXPECT_GT(excused.repaired_masks.total.exceeded, 1000u);
}

}  // namespace
}  // namespace octacut
