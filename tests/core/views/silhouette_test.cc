#include "core/views/silhouette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "core/views/view_set.h"
#include "tests/core/views/random_views.h"

namespace octacut {
namespace {

using testing::Random;
using testing::RandomViewOfCube;
using testing::ViewOfCube;

// A few discs of object.
cv::Mat RandomMask(Random& random, int width, int height) {
  cv::Mat mask(height, width, CV_8UC1, cv::Scalar::all(0));
  for (int i = 0; i < 6; ++i) {
    const cv::Point center(random.Integer(0, width), random.Integer(0, height));
    cv::circle(mask,
               center,
               random.Integer(2, width / 5),
               i % 3 == 2 ? 0 : 255,
               cv::FILLED);
  }
  return mask;
}

bool IsObject(const cv::Mat& mask, int x, int y) {
  return mask.at<uint8_t>(y, x) >= 128;
}

Containment BruteForce(
    const cv::Mat& mask, double u0, double v0, double u1, double v1) {
  if (u0 < 0 || v0 < 0 || u1 > mask.cols || v1 > mask.rows) {
    return Containment::kMixed;
  }
  int object = 0;
  int background = 0;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      // A pixel owns its left and upper side; the last ones the frame's too.
      const auto touches = [](double low, double high, int i, int size) {
        return high >= i && (low < i + 1 || (i + 1 == size && low <= size));
      };
      if (touches(u0, u1, x, mask.cols) && touches(v0, v1, y, mask.rows)) {
        (IsObject(mask, x, y) ? object : background) += 1;
      }
    }
  }
  return object == 0       ? Containment::kBackground
         : background == 0 ? Containment::kObject
                           : Containment::kMixed;
}

TEST(Silhouette, RectanglesAgreeWithBruteForce) {
  Random random(1);
  int seen[3] = {0, 0, 0};
  for (int round = 0; round < 6; ++round) {
    const cv::Mat mask = RandomMask(random, 48, 40);
    const Silhouette silhouette(mask);
    for (int i = 0; i < 300; ++i) {
      double u0 = random.Uniform(-2, 50);
      double v0 = random.Uniform(-2, 42);
      double u1 = u0 + random.Uniform(0, 6);
      double v1 = v0 + random.Uniform(0, 6);
      if (i % 3 == 0) {  // exactly at pixel borders
        u0 = std::round(u0);
        v0 = std::round(v0);
        u1 = std::round(u1);
        v1 = std::round(v1);
      }
      const Containment expected =
          BruteForce(mask, float(u0), float(v0), float(u1), float(v1));
      ASSERT_EQ(silhouette.Test(float(u0), float(v0), float(u1), float(v1)),
                expected)
          << u0 << " " << v0 << " " << u1 << " " << v1;
      ++seen[int(expected)];
    }
  }
  for (const int count : seen) {
    EXPECT_GT(count, 50);
  }
}

TEST(Silhouette, HalfCoveredPixelsAreObject) {
  cv::Mat mask(4, 4, CV_8UC1, cv::Scalar::all(127));
  EXPECT_EQ(Silhouette(mask).Test(0, 0, 4, 4), Containment::kBackground);
  mask.setTo(128);
  EXPECT_EQ(Silhouette(mask).Test(0, 0, 4, 4), Containment::kObject);
}

TEST(Silhouette, TellsNothingOutOfTheFrameOrOfNan) {
  const Silhouette silhouette(cv::Mat(10, 10, CV_8UC1, cv::Scalar::all(0)));
  EXPECT_EQ(silhouette.Test(0, 0, 10, 10), Containment::kBackground);
  EXPECT_EQ(silhouette.Test(-0.1f, 0, 5, 5), Containment::kMixed);
  EXPECT_EQ(silhouette.Test(0, 0, 5, 10.1f), Containment::kMixed);
  EXPECT_EQ(silhouette.Test(20, 20, 30, 30), Containment::kMixed);
  const float nan = std::nanf("");
  EXPECT_EQ(silhouette.Test(nan, 0, 5, 5), Containment::kMixed);
  EXPECT_EQ(silhouette.Test(0, 0, 5, nan), Containment::kMixed);
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(silhouette.Test(-infinity, 0, infinity, 5), Containment::kMixed);
}

TEST(Silhouette, CoverageIsBilinear) {
  Random random(2);
  const cv::Mat mask = RandomMask(random, 20, 16);
  const Silhouette silhouette(mask);
  const auto at = [&](int x, int y) {
    return double(mask.at<uint8_t>(std::clamp(y, 0, 15), std::clamp(x, 0, 19)));
  };
  for (int i = 0; i < 500; ++i) {
    const double u = random.Uniform(0, 20);
    const double v = random.Uniform(0, 16);
    const int x = int(std::floor(u - 0.5));
    const int y = int(std::floor(v - 0.5));
    const double fx = u - 0.5 - x;
    const double fy = v - 0.5 - y;
    const double expected =
        (1 - fy) * ((1 - fx) * at(x, y) + fx * at(x + 1, y)) +
        fy * ((1 - fx) * at(x, y + 1) + fx * at(x + 1, y + 1));
    ASSERT_NEAR(silhouette.Coverage(float(u), float(v)), expected, 1e-2);
  }
  EXPECT_EQ(silhouette.Coverage(-0.5f, 3), 255);
  EXPECT_EQ(silhouette.Coverage(3, 16.5f), 255);
  EXPECT_EQ(silhouette.Coverage(std::nanf(""), 3), 255);
}

TEST(Silhouette, SignedDistanceIsThatOfADiscToAQuarterOfAPixel) {
  constexpr double kRadius = 20.3;
  const Eigen::Vector2d center(40.6, 30.2);
  cv::Mat mask(60, 80, CV_8UC1);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const double distance =
          kRadius - (Eigen::Vector2d(x + 0.5, y + 0.5) - center).norm();
      mask.at<uint8_t>(y, x) =
          uint8_t(std::lround(255 * std::clamp(distance + 0.5, 0.0, 1.0)));
    }
  }
  const Silhouette silhouette(mask);
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d p(random.Uniform(2, 78), random.Uniform(2, 58));
    const double expected = kRadius - (p - center).norm();
    const double found = silhouette.SignedDistance(float(p.x()), float(p.y()));
    ASSERT_NEAR(found, expected, 0.6) << p.transpose();
    if (std::abs(expected) < 0.4) {
      ASSERT_NEAR(found, expected, 0.25) << p.transpose();
    }
  }
}

TEST(Silhouette, SignedDistanceIsFarWithoutABorderOrOutOfTheFrame) {
  cv::Mat mask(12, 16, CV_8UC1, cv::Scalar::all(255));
  EXPECT_EQ(Silhouette(mask).SignedDistance(5, 5), Silhouette::kFarInside);
  EXPECT_EQ(Silhouette(mask).SignedDistance(-0.1f, 5), Silhouette::kFarInside);
  EXPECT_EQ(Silhouette(mask).SignedDistance(std::nanf(""), 5),
            Silhouette::kFarInside);
  mask.setTo(0);
  EXPECT_EQ(Silhouette(mask).SignedDistance(5, 5), -Silhouette::kFarInside);
}

TEST(Silhouette, SaysNothingOfUnknownPixels) {
  // Background, but for the last six columns, which no photograph covers.
  cv::Mat mask(12, 16, CV_8UC1, cv::Scalar::all(0));
  mask.colRange(10, 16).setTo(255);
  cv::Mat unknown = mask.clone();
  const Silhouette silhouette(mask, unknown);
  EXPECT_TRUE(silhouette.IsKnown(9.5f, 5.5f));
  EXPECT_FALSE(silhouette.IsKnown(10.5f, 5.5f));
  EXPECT_FALSE(silhouette.IsKnown(16.5f, 5.5f));
  EXPECT_GE(silhouette.SignedDistance(10.5f, 5.5f), Silhouette::kFarInside);
  // Their edge is no border of the object.
  EXPECT_EQ(silhouette.SignedDistance(9.5f, 5.5f), -Silhouette::kFarInside);
  EXPECT_EQ(silhouette.Test(8, 3, 12, 6), Containment::kMixed);
  // Known object beside them.
  mask.colRange(6, 10).setTo(255);
  EXPECT_NEAR(Silhouette(mask, unknown).SignedDistance(9.5f, 5.5f), 3.5, 0.1);
  EXPECT_NEAR(Silhouette(mask, unknown).SignedDistance(5.5f, 5.5f), -0.5, 0.1);
}

TEST(Silhouette, KnowsRectanglesWithoutUnknownPixels) {
  const cv::Mat mask(12, 16, CV_8UC1, cv::Scalar::all(0));
  EXPECT_TRUE(Silhouette(mask).KnowsAll(0, 0, 16, 12));
  EXPECT_FALSE(Silhouette(mask).KnowsAll(-0.1f, 0, 16, 12));
  // The corners of an undistorted photograph.
  cv::Mat unknown(12, 16, CV_8UC1, cv::Scalar::all(0));
  unknown.colRange(12, 16).setTo(255);
  unknown(cv::Rect(0, 0, 2, 6)).setTo(255);
  const Silhouette silhouette(mask, unknown);
  EXPECT_TRUE(silhouette.KnowsAll(3, 0, 11, 12));
  EXPECT_FALSE(silhouette.KnowsAll(2, 0, 11, 12));  // interpolates beyond
  EXPECT_FALSE(silhouette.KnowsAll(3, 0, 11.5f, 12));
  // Amid known pixels.
  unknown.setTo(0);
  unknown.at<uint8_t>(6, 8) = 255;
  EXPECT_FALSE(Silhouette(mask, unknown).KnowsAll(1, 1, 2, 2));
  // None, or a single column.
  unknown.setTo(255);
  for (int run = 0; run < 2; ++run) {
    for (int x = 0; x <= 16; ++x) {
      const auto u = float(x);
      EXPECT_FALSE(Silhouette(mask, unknown).KnowsAll(u, 6, u, 6)) << x;
    }
    unknown.col(5).setTo(0);
  }
}

struct PreparedRandomView {
  cv::Mat mask;
  Silhouette silhouette;
  ViewProjection projection;
};
PreparedRandomView PrepareRandomView(Random& random) {
  const ViewOfCube v = RandomViewOfCube(random, 3);
  PreparedRandomView result;
  result.mask = RandomMask(random, v.view.camera.width, v.view.camera.height);
  result.silhouette = Silhouette(result.mask);
  result.projection = MakeViewProjection(v.view, v.cube);
  return result;
}

// What a cube is said to be holds for every point of it.
TEST(Silhouette, CubesAreJudgedConservatively) {
  Random random(3);
  int num_background = 0;
  int num_object = 0;
  for (int round = 0; round < 20; ++round) {
    const PreparedRandomView view = PrepareRandomView(random);
    for (int i = 0; i < 100; ++i) {
      const double half = std::pow(2.0, -random.Uniform(2, 7));
      const Eigen::Vector3d center = random.Point(half, 1 - half);
      const Containment containment = view.silhouette.TestCube(
          view.projection, center.cast<float>(), float(half));
      if (containment == Containment::kMixed) {
        continue;
      }
      const bool object = containment == Containment::kObject;
      (object ? num_object : num_background) += 1;
      for (int k = 0; k < 30; ++k) {
        // The first eight are the corners.
        Eigen::Vector3d offset = random.Point(-1, 1);
        if (k < 8) {
          offset = {k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0};
        }
        const Eigen::Vector3f h = view.projection.Homogeneous(
            (center + 0.9999 * half * offset).cast<float>());
        const int x = int(std::floor(h.x() / h.z()));
        const int y = int(std::floor(h.y() / h.z()));
        ASSERT_GT(h.z(), 0);
        ASSERT_EQ(IsObject(view.mask, x, y), object);
      }
    }
  }
  EXPECT_GT(num_background, 100);
  EXPECT_GT(num_object, 100);
}

TEST(Silhouette, SmallCubesAreDecidedUnlessTheyMeetAContour) {
  Random random(4);
  int mixed = 0;
  for (int round = 0; round < 20; ++round) {
    const PreparedRandomView view = PrepareRandomView(random);
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector3f center = random.Point(0.2, 0.8).cast<float>();
      const Eigen::Vector3f h = view.projection.Homogeneous(center);
      const int x = int(std::floor(h.x() / h.z()));
      const int y = int(std::floor(h.y() / h.z()));
      if (x < 1 || y < 1 || x + 1 >= view.mask.cols ||
          y + 1 >= view.mask.rows) {
        continue;
      }
      const cv::Mat around =
          view.mask(cv::Rect(x - 1, y - 1, 3, 3));  // a cube's reach
      const int count = cv::countNonZero(around);
      const Containment containment =
          view.silhouette.TestCube(view.projection, center, 1e-4f);
      if (count == 0) {
        EXPECT_EQ(containment, Containment::kBackground);
      } else if (count == 9) {
        EXPECT_EQ(containment, Containment::kObject);
      } else {
        ++mixed;
      }
    }
  }
  EXPECT_LT(mixed, 400);
}

TEST(Silhouette, CubesThatReachBehindTheCameraTellNothing) {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    const PreparedRandomView view = PrepareRandomView(random);
    const float half = 0.05f;
    for (const float along : {-2.0f, -0.05f, 0.0f, 0.05f}) {
      EXPECT_EQ(view.silhouette.TestCube(
                    view.projection,
                    view.projection.center +
                        along * view.projection.linear.row(2).transpose(),
                    half),
                Containment::kMixed);
    }
  }
}

TEST(Silhouette, TheShortTestForBackgroundAgreesWithTheLongOne) {
  Random random(7);
  int num_background = 0;
  for (int round = 0; round < 20; ++round) {
    const PreparedRandomView view = PrepareRandomView(random);
    for (int i = 0; i < 300; ++i) {
      const float half = float(std::pow(2.0, -random.Uniform(1, 8)));
      const Eigen::Vector3f center = random.Point(-2, 3).cast<float>();
      const bool expected =
          view.silhouette.TestCube(view.projection, center, half) ==
          Containment::kBackground;
      ASSERT_EQ(view.silhouette.IsBackgroundCube(view.projection, center, half),
                expected);
      num_background += expected;
    }
  }
  EXPECT_GT(num_background, 500);
}

TEST(Silhouette, BackgroundIsFartherFromTheObjectThanTheMargin) {
  cv::Mat mask = cv::Mat::zeros(40, 60, CV_8UC1);
  mask.at<uint8_t>(20, 30) = 255;  // [30, 31] x [20, 21]
  const Silhouette silhouette(mask);
  const auto test = [&](float u, float margin) {
    return silhouette.Test(u, 20.2f, u + 2, 20.8f, margin);
  };
  EXPECT_EQ(test(32.5f, 0), Containment::kBackground);
  EXPECT_EQ(test(32.5f, 1), Containment::kBackground);
  EXPECT_EQ(test(32.5f, 2), Containment::kMixed);
  EXPECT_EQ(test(26.5f, 1), Containment::kBackground);
  EXPECT_EQ(test(26.5f, 2), Containment::kMixed);
  // The margin is no part of the frame test, and makes nothing object.
  EXPECT_EQ(test(0, 5), Containment::kBackground);
  EXPECT_EQ(test(-0.5f, 5), Containment::kMixed);
  EXPECT_EQ(silhouette.Test(30.2f, 20.2f, 30.8f, 20.8f, 5),
            Containment::kObject);
}

TEST(PrepareViews, GivesPyramidsToViewsWithImagesOnly) {
  Random random(6);
  ViewOfCube v = RandomViewOfCube(random, 3);
  const cv::Size size(v.view.camera.width, v.view.camera.height);
  v.view.mask = cv::Mat(size, CV_8UC1, cv::Scalar::all(255));
  Scene scene;
  scene.views.push_back(v.view);
  scene.views.push_back(v.view);
  scene.views[1].image = cv::Mat(size, CV_8UC3, cv::Scalar(10, 20, 30));
  scene.views[1].scale = 0.5;
  const ViewSet views = PrepareViews(scene, v.cube, Context(2), 3);
  EXPECT_EQ(views[0].mask_tolerance, 3);
  EXPECT_EQ(views[1].mask_tolerance, 1.5f);
  ASSERT_EQ(views.size(), 2u);
  EXPECT_EQ(views[0].pyramid.NumLevels(), 0);
  EXPECT_GT(views[1].pyramid.NumLevels(), 1);
  const Float4 color = views[1].pyramid.Level(0).Sample(5, 5);
  EXPECT_EQ(color[0], 10);
  EXPECT_EQ(color[2], 30);
  EXPECT_EQ(views[0].projection.linear, views[1].projection.linear);
  EXPECT_EQ(views[0].silhouette.Test(1, 1, 2, 2), Containment::kObject);
}

}  // namespace
}  // namespace octacut
