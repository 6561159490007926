// What silhouettes and photographs say of meshes that are right, or wrong by
// known amounts, on rendered scenes.
#include "core/benchmark/evaluate/evaluate_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/benchmark/evaluate/reprojection_pair.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class EvaluateMeshTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    SceneSpec spec = QuickScene("torus", 240, 180, 24);
    synthetic_ = new SyntheticScene(MakeScene(spec, Context(2)));
    scene_ = new Scene(ToScene(*synthetic_));
  }
  static void TearDownTestSuite() {
    delete synthetic_;
    delete scene_;
    synthetic_ = nullptr;
    scene_ = nullptr;
  }

  // The truth, moved outward by so many pixels.
  static IndexedMesh Moved(double pixels) {
    IndexedMesh mesh = synthetic_->reference;
    const View& view = scene_->views[0];
    const double pixel = view.Center().norm() / view.camera.fx;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      mesh.positions[i] += pixels * pixel * mesh.normals[i].cast<double>();
    }
    return mesh;
  }
  static MeshEvaluation Evaluate(const IndexedMesh& mesh, int threads = 2) {
    return EvaluateMesh(mesh, scene_->views, {}, Context(threads));
  }

  static inline SyntheticScene* synthetic_ = nullptr;
  static inline Scene* scene_ = nullptr;
};

TEST_F(EvaluateMeshTest, TheTruthAgrees) {
  const MeshEvaluation found = Evaluate(Moved(0));
  EXPECT_GT(found.silhouettes.intersection_over_union, 0.995);
  EXPECT_LT(found.silhouettes.missed, 0.003);
  EXPECT_LT(found.silhouettes.excess, 0.003);
  EXPECT_LT(found.silhouettes.outline_mean, 0.08);
  EXPECT_LT(found.silhouettes.outline_percentile_95, 0.2);
  ASSERT_TRUE(found.reprojection);
  EXPECT_GT(found.reprojection->mean_correlation, 0.9);
  EXPECT_GT(found.reprojection->compared_fraction, 0.6);
  EXPECT_GT(found.reprojection->num_windows, 100000u);
}

TEST_F(EvaluateMeshTest, SilhouettesTellTooMuchFromTooLittle) {
  const SilhouetteAgreement fat = Evaluate(Moved(1)).silhouettes;
  const SilhouetteAgreement thin = Evaluate(Moved(-1)).silhouettes;
  EXPECT_GT(fat.excess, 10 * fat.missed);
  EXPECT_GT(thin.missed, 10 * thin.excess);
  for (const SilhouetteAgreement& wrong : {fat, thin}) {
    EXPECT_NEAR(wrong.outline_mean, 1, 0.15);
    EXPECT_LT(wrong.intersection_over_union, 0.98);
  }
  EXPECT_NEAR(Evaluate(Moved(3)).silhouettes.outline_mean, 3, 0.4);
}

TEST_F(EvaluateMeshTest, PhotographsTellHowFarTheSurfaceIsOff) {
  const double right = Evaluate(Moved(0)).reprojection->mean_correlation;
  const double near = Evaluate(Moved(-1)).reprojection->mean_correlation;
  const double far = Evaluate(Moved(-3)).reprojection->mean_correlation;
  EXPECT_LT(near, right - 0.01);
  EXPECT_LT(far, near - 0.05);
}

TEST_F(EvaluateMeshTest, SameFiguresForAnyNumberOfThreads) {
  const IndexedMesh mesh = Moved(0.7);
  const MeshEvaluation one = Evaluate(mesh, 1);
  const MeshEvaluation three = Evaluate(mesh, 3);
  EXPECT_EQ(one.silhouettes.outline_mean, three.silhouettes.outline_mean);
  EXPECT_EQ(one.silhouettes.missed, three.silhouettes.missed);
  EXPECT_EQ(one.reprojection->mean_correlation,
            three.reprojection->mean_correlation);
  EXPECT_EQ(one.reprojection->num_windows, three.reprojection->num_windows);
}

TEST_F(EvaluateMeshTest, WithoutImagesSilhouettesAlone) {
  std::vector<View> views = scene_->views;
  for (View& view : views) {
    view.image = cv::Mat();
  }
  const IndexedMesh mesh = Moved(0);
  EXPECT_THAT([&] { EvaluateMesh(mesh, views, {}, Context(2)); },
              ThrowsMessage<InputError>(HasSubstr("view_000.jpg")));
  EvaluateMeshOptions options;
  options.photometric = false;
  const MeshEvaluation found = EvaluateMesh(mesh, views, options, Context(2));
  EXPECT_FALSE(found.reprojection);
  EXPECT_GT(found.silhouettes.intersection_over_union, 0.995);
}

TEST_F(EvaluateMeshTest, NeighborsAreTheNearestThatAreFarEnough) {
  ReprojectionOptions options;
  options.num_neighbors = 3;
  options.min_angle = 25;
  options.max_angle = 60;
  const auto neighbors =
      ReprojectionNeighbors(scene_->views, Eigen::Vector3d::Zero(), options);
  ASSERT_EQ(neighbors.size(), scene_->views.size());
  const auto angle = [&](size_t i, size_t j) {
    const Eigen::Vector3d a = scene_->views[i].Center().normalized();
    return std::acos(a.dot(scene_->views[j].Center().normalized())) * 180 /
           3.14159265358979;
  };
  for (size_t i = 0; i < neighbors.size(); ++i) {
    ASSERT_EQ(neighbors[i].size(), 3u);
    double last = 25;
    for (const size_t j : neighbors[i]) {
      EXPECT_GE(angle(i, j), last - 1e-9);
      last = angle(i, j);
    }
    for (size_t j = 0; j < scene_->views.size(); ++j) {
      const bool taken =
          std::count(neighbors[i].begin(), neighbors[i].end(), j);
      EXPECT_FALSE(!taken && j != i && angle(i, j) > 25 &&
                   angle(i, j) < last - 1e-9);
    }
  }
}

// A view beside itself, with a depth of its own making.
class OneViewTest : public ::testing::Test {
 protected:
  OneViewTest() : grey_(60, 80, CV_32FC1), depth_(60, 80, CV_32FC1, 4.0) {
    view_.camera = {80, 60, 90, 90, 40, 30};
    for (int y = 0; y < grey_.rows; ++y) {
      for (int x = 0; x < grey_.cols; ++x) {
        grey_.at<float>(y, x) = 100 + 40 * std::sin(0.7 * x) * std::cos(y);
      }
    }
  }
  PairSums Compare(const cv::Mat& grey, const cv::Mat& neighbor_depth) {
    compared_ = cv::Mat::zeros(60, 80, CV_8UC1);
    return CompareWithNeighbor(
        {view_, grey, depth_}, {view_, grey_, neighbor_depth}, &compared_);
  }

  View view_;
  cv::Mat grey_;
  cv::Mat depth_;
  cv::Mat compared_;
};

TEST_F(OneViewTest, AgreesWithItself) {
  const PairSums sums = Compare(grey_, depth_);
  // Windows of 7 x 7 within the frame; its last row and column have no four
  // neighbours to be sampled from.
  EXPECT_NEAR(double(sums.num_whole), 54 * 74, 140);
  EXPECT_EQ(sums.num_windows, sums.num_whole);
  EXPECT_EQ(cv::countNonZero(compared_), int(sums.num_whole));
  EXPECT_NEAR(sums.sum / double(sums.num_windows), 1, 1e-4);
}

TEST_F(OneViewTest, NegativesDisagreeAndBrightnessDoesNotMatter) {
  const PairSums negative = Compare(200 - grey_, depth_);
  EXPECT_NEAR(negative.sum / double(negative.num_windows), -1, 1e-4);
  const PairSums brighter = Compare(0.5 * grey_ + 90, depth_);
  EXPECT_NEAR(brighter.sum / double(brighter.num_windows), 1, 1e-4);
}

TEST_F(OneViewTest, WhatIsHiddenIsNotCompared) {
  EXPECT_EQ(Compare(grey_, cv::Mat(60, 80, CV_32FC1, 3.0)).num_whole, 0u);
  EXPECT_EQ(Compare(grey_, cv::Mat(60, 80, CV_32FC1, 0.0)).num_whole, 0u);
  // Behind by less than three pixels of 4 / 90.
  EXPECT_GT(Compare(grey_, cv::Mat(60, 80, CV_32FC1, 3.9)).num_whole, 3000u);
}

TEST_F(OneViewTest, PlainWindowsAreLeftOut) {
  const PairSums sums = Compare(0.01 * grey_, depth_);
  EXPECT_GT(sums.num_whole, 3000u);
  EXPECT_EQ(sums.num_windows, 0u);
}

TEST(ReprojectionOptions, BadValuesAreNamed) {
  ReprojectionOptions options;
  options.min_angle = 50;
  EXPECT_THAT([&] { options.Check(); },
              ThrowsMessage<OptionError>(HasSubstr("min_angle = 50")));
}

}  // namespace
}  // namespace octacut
