#include "core/hull/visual_hull.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/benchmark/synthetic/move_mask_border.h"
#include "tests/core/grid/codes_of.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using testing::MakeTestScene;
using testing::TestScene;

VisualHullOptions Level(int level) {
  VisualHullOptions options;
  options.hull_level = level;
  return options;
}

template <typename Body>
void ForEachVoxelOfCube(int level, Body&& body) {
  const int n = 1 << level;
  for (int z = 0; z < n; ++z) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        body(Eigen::Vector3i(x, y, z));
      }
    }
  }
}

// Whether the pixel rectangle around the voxel is background, by the pixels.
bool IsBackground(const TestScene& test,
                  const View& view,
                  const Eigen::Vector3i& voxel,
                  int level) {
  Eigen::AlignedBox2d rectangle;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d offset(corner & 1, corner >> 1 & 1, corner >> 2);
    const Eigen::Vector3d unit = (voxel.cast<double>() + offset) / (1 << level);
    const Eigen::Vector3d in_cam =
        view.cam_from_world * testing::ToWorld(test.region.cube, unit);
    rectangle.extend(view.camera.Project(in_cam));
  }
  constexpr double kSlack = 1e-2;  // single precision of the code under test
  const Eigen::Vector2d min = rectangle.min().array() + kSlack;
  const Eigen::Vector2d max = rectangle.max().array() - kSlack;
  if ((min.array() < 0).any() || max.x() > view.camera.width ||
      max.y() > view.camera.height) {
    return false;
  }
  for (int y = int(min.y()); y <= std::min(int(max.y()), view.mask.rows - 1);
       ++y) {
    for (int x = int(min.x()); x <= std::min(int(max.x()), view.mask.cols - 1);
         ++x) {
      if (view.mask.at<uint8_t>(y, x) >= 128) {
        return false;
      }
    }
  }
  return true;
}

class HullOf : public ::testing::TestWithParam<const char*> {};

TEST_P(HullOf, HoldsEveryVoxelThatTheObjectTouches) {
  const TestScene test = MakeTestScene(GetParam());
  constexpr int kLevel = 5;
  const VisualHull hull = ComputeVisualHull(
      test.views, TestScene::UnitBox(), Level(kLevel), Context(2));
  EXPECT_EQ(hull.summary.num_voxels, hull.voxels.Size());
  // A pixel is object where at least half of it is.
  const double margin = 0.75 * test.PixelSize();
  int num_touched = 0;
  ForEachVoxelOfCube(kLevel, [&](const Eigen::Vector3i& voxel) {
    bool touched = false;
    for (int k = 0; k < 27; ++k) {  // corners, middles, centre
      const Eigen::Vector3d offset(k % 3, k / 3 % 3, k / 9);
      touched |= test.Value((voxel.cast<double>() + offset / 2) /
                            (1 << kLevel)) < -margin;
    }
    num_touched += touched;
    ASSERT_TRUE(!touched || hull.voxels.Contains(voxel)) << voxel.transpose();
  });
  EXPECT_GT(num_touched, 100);
  EXPECT_LT(hull.voxels.Size(), 32u * 32 * 32 / 2);
}

TEST_P(HullOf, LeavesOutOnlyWhatIsBackgroundInSomeView) {
  const TestScene test = MakeTestScene(GetParam(), 120, 90, 12);
  constexpr int kLevel = 5;
  const VisualHull hull = ComputeVisualHull(
      test.views, TestScene::UnitBox(), Level(kLevel), Context(2));
  int num_left_out = 0;
  ForEachVoxelOfCube(kLevel, [&](const Eigen::Vector3i& voxel) {
    if (hull.voxels.Contains(voxel)) {
      return;
    }
    ++num_left_out;
    bool background = false;
    for (const View& view : test.scene.views) {
      background = background || IsBackground(test, view, voxel, kLevel);
    }
    ASSERT_TRUE(background) << voxel.transpose();
  });
  EXPECT_GT(num_left_out, 1000);
}

INSTANTIATE_TEST_SUITE_P(Objects,
                         HullOf,
                         ::testing::Values("torus", "fingers"),
                         [](const auto& instance) {
                           return std::string(instance.param);
                         });

// The hull is what is left at the end, however it was refined.
TEST(VisualHull, EqualsTestingEveryVoxelAlone) {
  const TestScene test = MakeTestScene("box", 120, 90, 12);
  constexpr int kLevel = 5;
  const VisualHull hull = ComputeVisualHull(
      test.views, TestScene::UnitBox(), Level(kLevel), Context(2));
  ForEachVoxelOfCube(kLevel, [&](const Eigen::Vector3i& voxel) {
    bool background = false;
    for (const PreparedView& view : test.views) {
      background |= view.silhouette.TestCube(view.projection,
                                             VoxelCenter(voxel, kLevel),
                                             0.5f / (1 << kLevel)) ==
                    Containment::kBackground;
    }
    // The same but for rounding at the rectangles' sides.
    if (hull.voxels.Contains(voxel)) {
      ASSERT_FALSE(background) << voxel.transpose();
    }
  });
  size_t tested = 0;
  ASSERT_EQ(hull.summary.tested_voxels.size(), size_t(kLevel) + 1);
  for (const size_t count : hull.summary.tested_voxels) {
    tested += count;
  }
  EXPECT_EQ(hull.summary.tested_voxels[0], 1u);
  EXPECT_LT(tested, 32u * 32 * 32);  // adaptive
}

TEST(VisualHull, IsNestedAndTheSameForAnyNumberOfThreads) {
  const TestScene test = MakeTestScene("cup", 120, 90, 12);
  const VisualHull fine =
      ComputeVisualHull(test.views, TestScene::UnitBox(), Level(6), Context(1));
  for (const int num_threads : {2, 4}) {
    const VisualHull again = ComputeVisualHull(
        test.views, TestScene::UnitBox(), Level(6), Context(num_threads));
    EXPECT_EQ(CodesOf(again.voxels), CodesOf(fine.voxels));
    EXPECT_EQ(again.summary.tested_voxels, fine.summary.tested_voxels);
  }
  const VisualHull coarse =
      ComputeVisualHull(test.views, TestScene::UnitBox(), Level(5), Context(2));
  for (const MortonCode code : CodesOf(fine.voxels)) {
    ASSERT_NE(coarse.voxels.Find(ParentCode(code)), VoxelGrid::kNone);
  }
}

TEST(VisualHull, TheBoxClips) {
  const TestScene test = MakeTestScene("sphere", 120, 90, 12);
  const Eigen::AlignedBox3f box(Eigen::Vector3f(0, 0.3f, 0),
                                Eigen::Vector3f(0.6f, 1, 0.5f));
  constexpr int kLevel = 5;
  const VisualHull whole = ComputeVisualHull(
      test.views, TestScene::UnitBox(), Level(kLevel), Context(2));
  const VisualHull clipped =
      ComputeVisualHull(test.views, box, Level(kLevel), Context(2));
  EXPECT_LT(clipped.voxels.Size(), whole.voxels.Size() / 2);
  whole.voxels.ForEach([&](VoxelGrid::Index, MortonCode code) {
    const Eigen::Vector3i voxel = DecodeMorton(code);
    const Eigen::Vector3f corner = voxel.cast<float>() / (1 << kLevel);
    const Eigen::AlignedBox3f cell(
        corner, corner + Eigen::Vector3f::Constant(1.0f / (1 << kLevel)));
    ASSERT_EQ(clipped.voxels.Contains(voxel), box.intersects(cell));
  });
}

TEST(VisualHull, APointIsInsideWhereEveryViewShowsTheObject) {
  const TestScene test = MakeTestScene("torus");
  const double margin = 1.5 * test.PixelSize();
  testing::Random random(1);
  int num_inside = 0;
  int num_outside = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d point = random.Point(0, 1);
    const bool inside =
        IsInsideHull(test.views, TestScene::UnitBox(), point.cast<float>());
    if (test.Value(point) < -margin) {
      EXPECT_TRUE(inside);
      ++num_inside;
    }
    bool background = false;
    for (const View& view : test.scene.views) {
      const Eigen::Vector2d pixel = view.camera.Project(
          view.cam_from_world * testing::ToWorld(test.region.cube, point));
      const int x = int(std::floor(pixel.x()));
      const int y = int(std::floor(pixel.y()));
      if (x < 1 || y < 1 || x + 1 >= view.mask.cols ||
          y + 1 >= view.mask.rows) {
        continue;
      }
      const cv::Mat around = view.mask(cv::Rect(x - 1, y - 1, 3, 3));
      background = background || cv::countNonZero(around) == 0;
    }
    if (background) {
      EXPECT_FALSE(inside);
      ++num_outside;
    }
  }
  EXPECT_GT(num_inside, 50);
  EXPECT_GT(num_outside, 500);
  EXPECT_FALSE(IsInsideHull(
      test.views, TestScene::UnitBox(), Eigen::Vector3f(0.5f, 0.5f, 1.01f)));
}

TEST(VisualHull, KeepsTheObjectOfMasksThatAreTooSmallByTheTolerance) {
  TestScene test = MakeTestScene("sphere", 160, 120, 20);
  constexpr int kMaskError = 3;
  for (View& view : test.scene.views) {
    view.mask = MoveMaskBorder(view.mask, -kMaskError);
  }
  const auto missed = [&](double tolerance) {
    test.views =
        PrepareViews(test.scene, test.region.cube, Context(2), tolerance);
    const VoxelGrid hull =
        ComputeVisualHull(
            test.views, TestScene::UnitBox(), Level(6), Context(2))
            .voxels;
    size_t count = 0;
    for (int i = 0; i < (1 << 18); ++i) {
      const Eigen::Vector3i voxel = DecodeMorton(MortonCode(i));
      const double value = test.Value(VoxelCenter(voxel, 6).cast<double>());
      count += value < 0 && hull.Find(MortonCode(i)) == VoxelGrid::kNone;
    }
    return count;
  };
  EXPECT_GT(missed(0), 1000u);
  EXPECT_EQ(missed(kMaskError), 0u);
}

TEST(VisualHull, AnEmptyOneIsAnInputError) {
  TestScene test = MakeTestScene("sphere", 80, 60, 6);
  const Eigen::AlignedBox3f corner(Eigen::Vector3f::Zero(),
                                   Eigen::Vector3f::Constant(0.05f));
  EXPECT_THROW(ComputeVisualHull(test.views, corner, Level(4), Context(1)),
               InputError);
  test.scene.views[2].mask.setTo(0);
  test.views = PrepareViews(test.scene, test.region.cube, Context(1));
  try {
    ComputeVisualHull(test.views, TestScene::UnitBox(), Level(4), Context(1));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("hull is empty"));
  }
}

TEST(VisualHullOptions, AreRejectedWithFieldAndConstraint) {
  EXPECT_NO_THROW(VisualHullOptions().Check());
  EXPECT_NO_THROW(Level(2).Check());
  EXPECT_NO_THROW(Level(10).Check());
  for (const int level : {-1, 1, 11}) {
    try {
      ComputeVisualHull(
          ViewSet(), TestScene::UnitBox(), Level(level), Context(1));
      FAIL() << "level " << level;
    } catch (const OptionError& error) {
      EXPECT_THAT(error.what(), HasSubstr("hull_level"));
      EXPECT_THAT(error.what(), HasSubstr(std::to_string(level)));
      EXPECT_THAT(error.what(), HasSubstr("2 .. 10"));
    }
  }
}

}  // namespace
}  // namespace octacut
