#include "core/benchmark/synthetic/render_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <opencv2/core.hpp>

#include "core/benchmark/synthetic/objects.h"
#include "core/benchmark/synthetic/polygonize.h"

namespace octacut {
namespace {

class RenderSphere : public ::testing::Test {
 protected:
  static constexpr double kRadius = 0.8;

  RenderSphere() {
    MakeMesh(40);
    lighting_.num_samples = 4;
    rig_.width = 160;
    rig_.height = 120;
    rig_.num_views = 4;
    texture_.kind = TextureKind::kPlain;
  }

  void MakeMesh(int resolution) {
    PolygonizeOptions options;
    options.resolution = resolution;
    mesh_ = Polygonize(MakeSphere(kRadius), options, context_);
    rays_ = std::make_unique<RayScene>(mesh_);
  }

  RenderedView Render(int view) const {
    const RenderSubject subject = MakeRenderSubject(
        mesh_, *rays_, texture_, lighting_, background_, context_);
    return RenderView(subject,
                      MakeLens(rig_),
                      MakeRig(rig_, subject.center, subject.radius)[view],
                      context_);
  }

  Context context_{2};
  IndexedMesh mesh_;
  std::unique_ptr<RayScene> rays_;
  RigOptions rig_;
  TextureOptions texture_;
  LightingOptions lighting_;
  BackgroundOptions background_;
};

TEST_F(RenderSphere, MaskIsTheAnalyticDisc) {
  MakeMesh(100);
  for (const double k1 : {0.0, 0.2}) {
    rig_.k1 = k1;
    const cv::Mat mask = Render(1).mask;
    const Lens lens = MakeLens(rig_);
    // The sphere fills 0.95 of the height; all rays within its cone hit.
    const double undistorted = 0.95 * rig_.height / 2;
    const double u = undistorted / lens.camera.fx;
    const double radius = undistorted * (1 + k1 * u * u);
    double area = 0;
    for (int y = 0; y < mask.rows; ++y) {
      for (int x = 0; x < mask.cols; ++x) {
        const double distance = std::hypot(x + 0.5 - 80, y + 0.5 - 60);
        const int value = mask.at<uint8_t>(y, x);
        if (distance < radius - 1) {
          ASSERT_EQ(value, 255);
        } else if (distance > radius + 1) {
          ASSERT_EQ(value, 0);
        } else {
          // A straight border: coverage falls from 1 to 0 over a pixel.
          ASSERT_NEAR(value / 255.0,
                      std::clamp(radius - distance + 0.5, 0.0, 1.0),
                      0.2);
        }
        area += value / 255.0;
      }
    }
    EXPECT_NEAR(area / (M_PI * radius * radius), 1, 2e-3) << k1;
  }
}

TEST_F(RenderSphere, BackgroundIsAGradientWithoutTheObject) {
  const RenderedView view = Render(0);
  const cv::Vec3b top = view.image.at<cv::Vec3b>(0, 0);
  const cv::Vec3b bottom = view.image.at<cv::Vec3b>(119, 0);
  EXPECT_GT(top[1], bottom[1]);
  EXPECT_EQ(view.image.at<cv::Vec3b>(0, 159), top);
}

TEST_F(RenderSphere, RoomStandsStill) {
  background_.kind = BackgroundKind::kRoom;
  const cv::Mat a = Render(0).image;
  const cv::Mat b = Render(1).image;
  cv::Scalar mean, deviation;
  cv::meanStdDev(a(cv::Rect(0, 0, 20, 120)), mean, deviation);
  EXPECT_GT(deviation[1], 3);
  EXPECT_GT(cv::norm(a, b, cv::NORM_INF), 20);
}

TEST_F(RenderSphere, LightsAreFixedToObjectOrCamera) {
  // One hard light from +x; a turntable sees the object from all sides.
  lighting_.lights = {{{1, 0, 0}, 0, {1, 1, 1}}};
  rig_.kind = RigKind::kTurntable;
  rig_.min_elevation = rig_.max_elevation = 0;
  const auto middle = [&](int view) {
    return static_cast<int>(Render(view).image.at<cv::Vec3b>(60, 80)[1]);
  };
  EXPECT_GT(middle(0), middle(2) + 50);  // from +x and from -x
  // In the camera's frame: from its own side.
  lighting_.fixed_to_camera = true;
  lighting_.lights[0].direction = {0, 0, -1};
  for (int view = 1; view < 4; ++view) {
    EXPECT_NEAR(middle(view), middle(0), 2);
  }
}

TEST_F(RenderSphere, ShinyObjectsHaveAHighlight) {
  lighting_.lights = {{{0, 0, -1}, 2, {0.5f, 0.5f, 0.5f}}};
  lighting_.fixed_to_camera = true;
  const auto brightest = [&] {
    double low, high;
    cv::minMaxLoc(Render(0).image.reshape(1), &low, &high);
    return high;
  };
  const double matte = brightest();
  lighting_.specular = 0.5;
  EXPECT_GT(brightest(), matte + 20);
}

}  // namespace
}  // namespace octacut
