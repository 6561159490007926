#include "core/crust/crust.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <queue>

#include "core/base/error.h"
#include "core/crust/medial_voxels.h"
#include "core/grid/morphology.h"
#include "core/grid/voxel_walk.h"
#include "tests/core/crust/labeled_shapes.h"
#include "tests/core/grid/codes_of.h"

namespace octacut {
namespace {

using testing::Ball;
using testing::Box;
using ::testing::HasSubstr;
using testing::LabelsOf;
using testing::LabelSolid;
using testing::OneLevel;
using testing::Rod;
using testing::Solid;

CrustOptions Dilation(int steps) {
  CrustOptions options;
  options.crust_dilation = steps;
  return options;
}

// Whether each voxel of the cube can be reached from its border without
// passing through the crust.
std::vector<uint8_t> FloodFromBorder(const VoxelGrid& crust) {
  const int n = crust.Resolution();
  std::vector<uint8_t> reached(size_t(n) * n * n, 0);
  std::queue<Eigen::Vector3i> queue;
  const auto visit = [&](const Eigen::Vector3i& voxel) {
    uint8_t& flag = reached[EncodeMorton(voxel)];
    if (!flag && !crust.Contains(voxel)) {
      flag = 1;
      queue.push(voxel);
    }
  };
  for (int i = 0; i < n * n; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Vector3i voxel;
      voxel[axis] = 0;
      voxel[(axis + 1) % 3] = i % n;
      voxel[(axis + 2) % 3] = i / n;
      visit(voxel);
      voxel[axis] = n - 1;
      visit(voxel);
    }
  }
  while (!queue.empty()) {
    const Eigen::Vector3i voxel = queue.front();
    queue.pop();
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3i next = NeighborVoxel(voxel, face);
      if ((next.array() >= 0).all() && (next.array() < n).all()) {
        visit(next);
      }
    }
  }
  return reached;
}

// No face is tied both ways, from whichever side, and every face at the
// crust's border is tied.
void ExpectTiesAgree(const Crust& crust) {
  ASSERT_EQ(crust.ties.size(), crust.voxels.Size());
  ASSERT_EQ(crust.prior.size(), crust.voxels.Size());
  const VoxelWalk walk(crust.voxels, Context(1));
  walk.ForEachWithNeighbors(
      0, walk.NumBricks(), [&](const VoxelSlot& slot, const auto& near) {
        const VoxelGrid::Index index = slot.index;
        for (int face = 0; face < kNumFaces; ++face) {
          bool outside = crust.ties[index] & OutsideTie(face);
          bool inside = crust.ties[index] & InsideTie(face);
          if (near[face] != VoxelGrid::kNone) {
            const int opposite = OppositeFace(face);
            outside |= bool(crust.ties[near[face]] & OutsideTie(opposite));
            inside |= bool(crust.ties[near[face]] & InsideTie(opposite));
          } else {
            EXPECT_TRUE(inside || outside);
          }
          EXPECT_FALSE(inside && outside) << index << ", face " << face;
        }
      });
}

// For a solid without cavities, the border towards what the outside reaches is
// tied to the outside, the other to the inside.
void ExpectCrustSeparates(const Crust& crust) {
  const std::vector<uint8_t> reached = FloodFromBorder(crust.voxels);
  const int n = crust.voxels.Resolution();
  const VoxelWalk walk(crust.voxels, Context(1));
  walk.ForEachWithNeighbors(
      0, walk.NumBricks(), [&](const VoxelSlot& slot, const auto& near) {
        const MortonCode code =
            VoxelGrid::CodeOf(crust.voxels.Bricks()[slot.brick], int(slot.bit));
        for (int face = 0; face < kNumFaces; ++face) {
          if (near[face] != VoxelGrid::kNone) {
            continue;
          }
          const Eigen::Vector3i across =
              NeighborVoxel(DecodeMorton(code), face);
          const bool in_cube =
              (across.array() >= 0).all() && (across.array() < n).all();
          const bool outside = !in_cube || reached[EncodeMorton(across)];
          EXPECT_EQ(bool(crust.ties[slot.index] & OutsideTie(face)), outside)
              << across.transpose();
        }
      });
}

TEST(InitialCrust, IsTheHullTiedToTheOutside) {
  const VoxelGrid hull = LabelSolid(Ball({0.5, 0.5, 0.5}, 0.3), 4, 2).voxels;
  const Crust crust = InitialCrust(hull, Context(2));
  EXPECT_EQ(CodesOf(crust.voxels), CodesOf(hull));
  ExpectTiesAgree(crust);
  for (const FaceTies ties : crust.ties) {
    EXPECT_EQ(ties & ~kAllOutside, 0);
  }
  for (const float prior : crust.prior) {
    EXPECT_EQ(prior, 1);
  }
}

struct NamedSolid {
  const char* name;
  Solid solid;
};
void PrintTo(const NamedSolid& solid, std::ostream* stream) {
  *stream << solid.name;
}

class RefinedCrust : public ::testing::TestWithParam<NamedSolid> {};

TEST_P(RefinedCrust, SeparatesInsideFromOutside) {
  const Solid& solid = GetParam().solid;
  for (const int dilation : {1, 2, 3}) {
    const Crust crust =
        RefineCrust(OneLevel(solid, 4), Dilation(dilation), Context(2));
    ASSERT_EQ(crust.voxels.Level(), 5);
    ExpectTiesAgree(crust);
    ExpectCrustSeparates(crust);
  }
}

TEST_P(RefinedCrust, IsTheDilatedCutOfTheCoarserLevel) {
  const Solid& solid = GetParam().solid;
  const LabelHierarchy hierarchy = OneLevel(solid, 4);
  std::vector<MortonCode> cut;
  hierarchy.Finest().voxels.ForEach(
      [&](VoxelGrid::Index index, MortonCode code) {
        if (IsCut(hierarchy.Finest().labels[index])) {
          for (MortonCode child = 0; child < 8; ++child) {
            cut.push_back(FirstChildCode(code) + child);
          }
        }
      });
  const VoxelGrid proxy = VoxelGrid::FromCodes(5, cut);
  for (const int dilation : {1, 2, 4}) {
    const Crust crust = RefineCrust(hierarchy, Dilation(dilation), Context(2));
    EXPECT_EQ(CodesOf(crust.voxels),
              CodesOf(Dilate(proxy, dilation, Context(1))));
    crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      ASSERT_EQ(crust.prior[index],
                hierarchy.InsideFraction(DecodeMorton(code), 5));
    });
  }
}

TEST_P(RefinedCrust, IsTheSameForAnyNumberOfThreads) {
  const LabelHierarchy hierarchy = OneLevel(GetParam().solid, 5);
  const Crust expected = RefineCrust(hierarchy, Dilation(2), Context(1));
  for (const int num_threads : {2, 4}) {
    const Crust crust =
        RefineCrust(hierarchy, Dilation(2), Context(num_threads));
    EXPECT_EQ(CodesOf(crust.voxels), CodesOf(expected.voxels));
    EXPECT_EQ(crust.ties, expected.ties);
    EXPECT_EQ(crust.prior, expected.prior);
    EXPECT_EQ(crust.num_medial_voxels, expected.num_medial_voxels);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Solids,
    RefinedCrust,
    ::testing::Values(
        NamedSolid{"Ball", Ball({0.47, 0.52, 0.5}, 0.35)},
        NamedSolid{"SmallBall", Ball({0.5, 0.5, 0.5}, 0.1)},
        NamedSolid{"Rod", Rod(1.5 / 16, 0.15, 0.85)},
        NamedSolid{"Plate", Box({0.1, 0.1, 0.45}, {0.9, 0.9, 0.58})},
        NamedSolid{"AtTheBorder", Box({-1, 0.2, 0.2}, {0.6, 0.7, 2})}),
    [](const auto& instance) { return std::string(instance.param.name); });

// After two refinements: the walk up through both crusts.
TEST(RefineCrust, SeparatesOnTheSecondLevelToo) {
  const Solid ball = Ball({0.47, 0.52, 0.5}, 0.35);
  LabelHierarchy hierarchy = OneLevel(ball, 3);
  for (int level = 4; level <= 5; ++level) {
    const Crust crust = RefineCrust(hierarchy, Dilation(1), Context(2));
    ASSERT_EQ(crust.voxels.Level(), level);
    ExpectTiesAgree(crust);
    ExpectCrustSeparates(crust);
    hierarchy.Add({crust.voxels, LabelsOf(ball, crust.voxels)});
  }
}

TEST(CrustOptions, AreRejectedWithFieldAndConstraint) {
  EXPECT_NO_THROW(CrustOptions().Check());
  for (const int dilation : {0, 9, -1}) {
    try {
      RefineCrust(OneLevel(Ball({0.5, 0.5, 0.5}, 0.3), 3),
                  Dilation(dilation),
                  Context(1));
      FAIL() << dilation;
    } catch (const OptionError& error) {
      EXPECT_THAT(error.what(), HasSubstr("crust_dilation"));
      EXPECT_THAT(error.what(), HasSubstr("1 .. 8"));
    }
  }
}

TEST(GrowCrust, ACutThatLiesStrictlyInsideTouchesNoBorder) {
  const Solid ball = Ball({0.5, 0.5, 0.5}, 0.3);
  const Crust crust = RefineCrust(OneLevel(ball, 4), Dilation(2), Context(2));
  size_t num_voxels = 99;
  EXPECT_EQ(
      CutAtBorder(crust, LabelsOf(ball, crust.voxels), Context(2), &num_voxels),
      std::vector<uint8_t>(crust.voxels.Size(), 0));
  EXPECT_EQ(num_voxels, 0u);
}

TEST(GrowCrust, GrowsWhereTheCutTouchesTheBorder) {
  const LabelHierarchy hierarchy = OneLevel(Ball({0.5, 0.5, 0.5}, 0.3), 4);
  const Crust crust = RefineCrust(hierarchy, Dilation(1), Context(2));
  // A cut that leaves the crust at its left.
  const std::vector<FaceLabels> labels =
      LabelsOf(Ball({0.46, 0.5, 0.5}, 0.3), crust.voxels);
  std::vector<uint8_t> touches(crust.voxels.Size(), 0);
  size_t expected = 0;
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    for (int face = 0; face < kNumFaces; ++face) {
      touches[index] |=
          IsCut(labels[index]) &&
          !crust.voxels.Contains(NeighborVoxel(DecodeMorton(code), face));
    }
    expected += touches[index];
  });
  ASSERT_GT(expected, 10u);
  ASSERT_LT(expected, crust.voxels.Size() / 2);
  size_t num_voxels = 0;
  EXPECT_EQ(CutAtBorder(crust, labels, Context(2), &num_voxels), touches);
  EXPECT_EQ(num_voxels, expected);
  const Crust grown = GrowCrust(hierarchy, crust, touches, 2, Context(2));
  EXPECT_EQ(
      CodesOf(grown.voxels),
      CodesOf(Union(crust.voxels,
                    Dilate(Subset(crust.voxels, touches), 2, Context(1)))));
  ExpectTiesAgree(grown);
  ExpectCrustSeparates(grown);
}

// A solved ball with a tunnel of voxels that leads into it.
TEST(WidenCrust, KnowsWhatWasSolvedAndWhatCoarserLevelsKnow) {
  const Solid ball = Ball({0.5, 0.5, 0.5}, 0.3);
  const LabelHierarchy hierarchy = OneLevel(ball, 4);
  const LabeledVoxels solved = LabelSolid(ball, 5, 2);
  std::vector<MortonCode> tunnel;
  for (int x = 16; x < 32; ++x) {
    tunnel.push_back(EncodeMorton(Eigen::Vector3i(x, 16, 16)));
  }
  const VoxelGrid voxels =
      Union(solved.voxels, VoxelGrid::FromCodes(5, tunnel));
  ASSERT_GT(voxels.Size(), solved.voxels.Size());
  const Crust crust = WidenCrust(hierarchy, solved, voxels, Context(2));
  EXPECT_EQ(CodesOf(crust.voxels), CodesOf(voxels));
  EXPECT_EQ(crust.num_medial_voxels, 0u);
  ExpectTiesAgree(crust);
  ExpectCrustSeparates(crust);
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    EXPECT_NEAR(crust.prior[index],
                std::popcount(LabelsOf(ball, DecodeMorton(code), 5)) / 6.0,
                solved.voxels.Contains(DecodeMorton(code)) ? 1e-6 : 0.5);
  });
}

TEST(AdoptCut, TakesTheCutForWhatIsKnown) {
  const LabelHierarchy hierarchy = OneLevel(Ball({0.5, 0.5, 0.5}, 0.3), 4);
  Crust crust = RefineCrust(hierarchy, Dilation(2), Context(2));
  const std::vector<FaceLabels> labels =
      LabelsOf(Ball({0.5, 0.5, 0.5}, 0.28), crust.voxels);
  AdoptCut(labels, kMinMedialDepth, Context(2), &crust);
  for (size_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(crust.prior[i], float(std::popcount(labels[i])) / kNumFaces);
  }
  ExpectTiesAgree(crust);
}

}  // namespace
}  // namespace octacut
