#include "core/evidence/covering_voxels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/hull/visual_hull.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::MakeTestScene;
using testing::TestScene;

constexpr int kCoveringVoxelsLevel = 5;

// A hand whose upper part a labelling of the hull has lost.
class CoveringVoxelsTest : public ::testing::Test {
 protected:
  CoveringVoxelsTest() : test_(MakeTestScene("fingers", 200, 150, 16)) {
    VisualHullOptions options;
    options.hull_level = kCoveringVoxelsLevel;
    hull_ = ComputeVisualHull(
                test_.views, TestScene::UnitBox(), options, Context(2))
                .voxels;
    labels_.assign(hull_.Size(), kAllFaces);
    is_lost_.assign(hull_.Size(), 0);
    const Eigen::AlignedBox3d& box = test_.synthetic.object.shape.box;
    hull_.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      const Eigen::Vector3d unit =
          VoxelCenter(DecodeMorton(code), kCoveringVoxelsLevel).cast<double>();
      if (testing::ToWorld(test_.region.cube, unit).z() >
          box.max().z() - 0.4 * box.sizes().z()) {
        labels_[index] = 0;
        is_lost_[index] = 1;
      }
    });
    candidates_.scores.assign(hull_.Size(), 0.5f);
  }

  std::vector<SampleMap> Maps(const std::vector<FaceLabels>& labels,
                              int num_threads = 2) const {
    return MapSamples(test_.views, hull_, labels, Context(num_threads));
  }

  CoveringVoxels Find(int num_threads = 2) const {
    return FindCoveringVoxels(test_.views,
                              hull_,
                              labels_,
                              Maps(labels_, num_threads),
                              candidates_,
                              Context(num_threads));
  }

  // The labelling with what has to be inside.
  std::vector<FaceLabels> Covered(const CoveringVoxels& covering) const {
    std::vector<FaceLabels> labels = labels_;
    for (size_t i = 0; i < labels.size(); ++i) {
      labels[i] = covering.is_covering[i] ? kAllFaces : labels[i];
    }
    return labels;
  }

  // Voxels that hang together, through faces, with the lowest of all.
  size_t CountAttached(const std::vector<FaceLabels>& labels) const {
    std::vector<uint8_t> is_found(hull_.Size());
    std::vector<Eigen::Vector3i> open;
    hull_.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      const Eigen::Vector3i voxel = DecodeMorton(code);
      if (labels[index] != 0 && (open.empty() || voxel.z() < open[0].z())) {
        open = {voxel};
      }
    });
    is_found[hull_.Find(open[0])] = 1;
    size_t count = 1;
    while (!open.empty()) {
      const Eigen::Vector3i voxel = open.back();
      open.pop_back();
      for (int face = 0; face < kNumFaces; ++face) {
        const Eigen::Vector3i beside = NeighborVoxel(voxel, face);
        const VoxelGrid::Index index = hull_.Find(beside);
        if (index != VoxelGrid::kNone && labels[index] != 0 &&
            !is_found[index]) {
          is_found[index] = 1;
          ++count;
          open.push_back(beside);
        }
      }
    }
    return count;
  }

  TestScene test_;
  VoxelGrid hull_;
  std::vector<FaceLabels> labels_;
  std::vector<uint8_t> is_lost_;
  CoverCandidates candidates_;
};

TEST_F(CoveringVoxelsTest, CoverEverythingAndHangTogether) {
  ASSERT_GT(CountSamples(Maps(labels_)).num_uncovered, 30u);
  const CoveringVoxels covering = Find();
  EXPECT_EQ(covering.num_impossible, 0u);
  EXPECT_GT(covering.num_voxels, 0u);
  const std::vector<FaceLabels> covered = Covered(covering);
  EXPECT_EQ(CountSamples(Maps(covered)).num_uncovered, 0u);
  EXPECT_EQ(
      CountAttached(covered),
      covered.size() - size_t(std::count(covered.begin(), covered.end(), 0)));
}

TEST_F(CoveringVoxelsTest, BringBackWhatWasLikely) {
  const size_t few = Find().num_voxels;
  candidates_.is_likely = is_lost_;
  const CoveringVoxels covering = Find();
  // The whole part instead of a sheet of it.
  EXPECT_GT(covering.num_voxels, 2 * few);
  for (size_t i = 0; i < is_lost_.size(); ++i) {
    EXPECT_LE(covering.is_covering[i], is_lost_[i]);
  }
}

TEST_F(CoveringVoxelsTest, PreferWhatIsLikely) {
  // How much of what covers is among every second voxel.
  const auto share = [&] {
    const CoveringVoxels covering = Find();
    size_t count = 0;
    for (size_t i = 0; i < candidates_.scores.size(); i += 2) {
      count += covering.is_covering[i];
    }
    return double(count) / double(covering.num_voxels);
  };
  const double by_chance = share();
  for (size_t i = 0; i < candidates_.scores.size(); i += 2) {
    candidates_.scores[i] = 0.9f;
  }
  EXPECT_GT(share(), by_chance + 0.1);
}

TEST_F(CoveringVoxelsTest, LeaveWhatMayNotBeTaken) {
  candidates_.scores.assign(hull_.Size(), -1.0f);
  const CoveringVoxels covering = Find();
  EXPECT_EQ(covering.num_voxels, 0u);
  EXPECT_EQ(covering.num_impossible, CountSamples(Maps(labels_)).num_uncovered);
}

TEST_F(CoveringVoxelsTest, AreTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(Find(1).is_covering, Find(4).is_covering);
}

}  // namespace
}  // namespace octacut
