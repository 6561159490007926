#include "core/texture/blend_weights.h"

#include <gtest/gtest.h>

#include "core/raycast/ray_scene.h"
#include "core/texture/charts.h"
#include "tests/core/texture/small_sphere.h"

namespace octacut {
namespace {

using testing::PhotographsOf;
using testing::SmallSphere;

// A sphere whose lower half no photograph shows, with the first view of each
// triangle chosen for it.
class HalfSeenSphere : public ::testing::Test {
 protected:
  HalfSeenSphere()
      : views_(FindFaceViews(mesh_, RayScene(mesh_), photographs_, Context(1))),
        costs_(
            ComputeViewCosts(mesh_, views_, photographs_.poses, Context(1))) {
    for (size_t f = 0; f < mesh_.triangles.size(); ++f) {
      chosen_.push_back(views_.Of(f).empty() ? kNoView : views_.Of(f)[0].view);
    }
  }

  bool IsSeen(uint32_t v) const {
    for (const uint32_t f : vertex_faces_.Of(v)) {
      if (chosen_[f] != kNoView) {
        return true;
      }
    }
    return false;
  }

  const IndexedMesh mesh_ = SmallSphere(4);
  const VertexCorners vertex_faces_ =
      FindVertexFaces(mesh_.positions.size(), mesh_.triangles);
  const Photographs photographs_ =
      PhotographsOf({{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}}, 160);
  const FaceViews views_;
  const ViewCosts costs_;
  std::vector<uint32_t> chosen_;
};

TEST_F(HalfSeenSphere, NoViewFadesIntoWhatNoneShows) {
  const VertexViews fading =
      FadeViews(mesh_, vertex_faces_, {views_, costs_, chosen_}, Context(1));
  size_t num_unseen = 0;
  for (uint32_t v = 0; v < mesh_.positions.size(); ++v) {
    if (IsSeen(v)) {
      EXPECT_FALSE(fading.Of(v).empty()) << v;
    } else {
      EXPECT_TRUE(fading.Of(v).empty()) << v;
      ++num_unseen;
    }
  }
  EXPECT_GT(num_unseen, mesh_.positions.size() / 20);
}

TEST_F(HalfSeenSphere, WeightsAreAtMostThoseOfTheBestResolution) {
  const VertexViews all =
      AllViews(mesh_, vertex_faces_, {views_, costs_, chosen_}, Context(1));
  float most = 0;
  for (const VertexView& entry : all.entries) {
    EXPECT_GT(entry.weight, 0);
    EXPECT_LE(entry.weight, kFullSupport);
    most = std::max(most, entry.weight);
  }
  EXPECT_GT(most, 0.8f * kFullSupport);
}

}  // namespace
}  // namespace octacut
