#include "core/crust/medial_voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "core/crust/crust.h"
#include "tests/core/crust/labeled_shapes.h"

namespace octacut {
namespace {

using testing::Ball;
using testing::Box;
using testing::OneLevel;
using testing::Rod;
using testing::Solid;

// The crust of the level after `coarse_level`.
Crust CrustOf(const Solid& solid, int coarse_level, int dilation = 2) {
  CrustOptions options;
  options.crust_dilation = dilation;
  return RefineCrust(OneLevel(solid, coarse_level), options, Context(2));
}

struct MedialVoxels {
  std::vector<Eigen::Vector3i> inside;
  std::vector<Eigen::Vector3i> outside;
};
MedialVoxels FindMedial(const Crust& crust) {
  MedialVoxels medial;
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    if (crust.ties[index] == kAllInside) {
      medial.inside.push_back(DecodeMorton(code));
    } else if ((crust.ties[index] & kAllOutside) == kAllOutside) {
      medial.outside.push_back(DecodeMorton(code));
    }
  });
  return medial;
}

double ValueAt(const Solid& solid, const Eigen::Vector3i& voxel, int level) {
  return solid((voxel.cast<double>().array() + 0.5).matrix() / (1 << level)) *
         (1 << level);
}

// Three voxels thick at the coarse level: all of it is in the crust.
TEST(MedialVoxels, AThinRodIsTiedOverItsWholeLength) {
  constexpr int kLevel = 6;
  for (const int dilation : {2, 3, 4}) {
    const Solid rod = Rod(1.5 / 32, 0.2, 0.8);
    const Crust crust = CrustOf(rod, kLevel - 1, dilation);
    EXPECT_GT(crust.num_medial_voxels, 0u);
    const MedialVoxels medial = FindMedial(crust);
    std::vector<int> slices(1 << kLevel, 0);
    for (const Eigen::Vector3i& voxel : medial.inside) {
      EXPECT_LT(ValueAt(rod, voxel, kLevel), 0) << voxel.transpose();
      ++slices[voxel.z()];
    }
    // Three voxels are left at either end.
    for (int z = int(0.2 * 64) + 4; z < int(0.8 * 64) - 3; ++z) {
      EXPECT_GT(slices[z], 0) << "dilation " << dilation << ", z " << z;
    }
  }
}

TEST(MedialVoxels, AThinPlateIsTiedAllOver) {
  constexpr int kLevel = 6;
  // Three voxels thick at the coarse level, not on its lattice's middle.
  const Solid plate = Box({0.2, 0.2, 15 / 32.0}, {0.8, 0.8, 18 / 32.0});
  const Crust crust = CrustOf(plate, kLevel - 1);
  std::vector<int> columns(size_t{64} * 64, 0);
  for (const Eigen::Vector3i& voxel : FindMedial(crust).inside) {
    EXPECT_LT(ValueAt(plate, voxel, kLevel), 0);
    ++columns[voxel.y() * 64 + voxel.x()];
  }
  for (int y = 18; y < 46; ++y) {
    for (int x = 18; x < 46; ++x) {
      EXPECT_GT(columns[y * 64 + x], 0) << x << ", " << y;
    }
  }
}

// Whether the crust spans a gap or leaves its middle out: the gap's inside
// has ties to the outside above every point of the plates.
TEST(MedialVoxels, AThinGapIsTiedAllOver) {
  constexpr int kLevel = 6;
  for (const int gap : {2, 3, 4}) {  // coarse voxels
    const Solid below = Box({0.1, 0.1, 0.2}, {0.9, 0.9, 15 / 32.0});
    const Solid above = Box({0.1, 0.1, (15 + gap) / 32.0}, {0.9, 0.9, 0.85});
    const Solid plates = [=](const Eigen::Vector3d& x) {
      return std::min(below(x), above(x));
    };
    const Crust crust = CrustOf(plates, kLevel - 1);
    std::vector<int> columns(size_t{64} * 64, 0);
    crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      const Eigen::Vector3i voxel = DecodeMorton(code);
      const bool in_gap = voxel.z() >= 30 && voxel.z() < 30 + 2 * gap;
      if (in_gap && (crust.ties[index] & kAllOutside)) {
        ++columns[voxel.y() * 64 + voxel.x()];
      }
    });
    for (const Eigen::Vector3i& voxel : FindMedial(crust).outside) {
      EXPECT_GT(ValueAt(plates, voxel, kLevel), 0);
    }
    for (int y = 14; y < 50; ++y) {
      for (int x = 14; x < 50; ++x) {
        EXPECT_GT(columns[y * 64 + x], 0) << x << ", " << y << ": " << gap;
      }
    }
  }
}

TEST(MedialVoxels, ThickPartsHaveNone) {
  const Crust crust = CrustOf(Ball({0.5, 0.5, 0.5}, 0.35), 5);
  EXPECT_EQ(crust.num_medial_voxels, 0u);
}

// At l0 the crust reaches far from the surface: what is deep is not thin.
// How many voxels are tied where all of 64^3 are in the crust.
size_t CountTied(const Solid& solid, int min_depth) {
  constexpr int kLevel = 6;
  std::vector<MortonCode> codes(size_t{1} << (3 * kLevel));
  std::iota(codes.begin(), codes.end(), MortonCode{0});
  const VoxelGrid voxels = VoxelGrid::FromCodes(kLevel, std::move(codes));
  std::vector<float> prior(voxels.Size());
  voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    prior[index] = ValueAt(solid, DecodeMorton(code), kLevel) < 0 ? 1 : 0;
  });
  std::vector<FaceTies> ties(voxels.Size());
  return TieMedialVoxels(voxels, prior, min_depth, Context(2), &ties);
}

TEST(MedialVoxels, DeepPartsHaveNone) {
  const Solid half_space = [](const Eigen::Vector3d& x) { return x.z() - 0.5; };
  EXPECT_EQ(CountTied(half_space, kMinMedialDepth), 0u);
}

TEST(MedialVoxels, AreAtLeastAsDeepAsAskedFor) {
  // Eight voxels thick: its two middle layers are four deep.
  const Solid plate = [](const Eigen::Vector3d& x) {
    return std::abs(x.z() - 0.5) - 4.0 / 64;
  };
  EXPECT_EQ(CountTied(plate, kMinMedialDepth), 2u * 64 * 64);
  EXPECT_EQ(CountTied(plate, 4), 2u * 64 * 64);
  EXPECT_EQ(CountTied(plate, 5), 0u);
}

TEST(MedialVoxels, KeepTiesAndCountWhatTheyTie) {
  const Solid rod = Rod(1.5 / 32, 0.2, 0.8);
  const Crust crust = CrustOf(rod, 5);
  // Without what the medial voxels have added: border faces alone.
  std::vector<FaceTies> border(crust.voxels.Size(), 0);
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    for (int face = 0; face < kNumFaces; ++face) {
      if (!crust.voxels.Contains(NeighborVoxel(DecodeMorton(code), face))) {
        border[index] |=
            crust.ties[index] & FaceTies(OutsideTie(face) | InsideTie(face));
      }
    }
  });
  std::vector<FaceTies> ties = border;
  const size_t count = TieMedialVoxels(
      crust.voxels, crust.prior, kMinMedialDepth, Context(2), &ties);
  EXPECT_EQ(ties, crust.ties);
  EXPECT_EQ(count, crust.num_medial_voxels);
  size_t num_changed = 0;
  for (size_t i = 0; i < ties.size(); ++i) {
    EXPECT_EQ(ties[i] & border[i], border[i]);
    num_changed += ties[i] != border[i];
  }
  EXPECT_LE(num_changed, count);
  EXPECT_GT(num_changed, 0u);
}

}  // namespace
}  // namespace octacut
