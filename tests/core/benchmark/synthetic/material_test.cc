#include "core/benchmark/synthetic/material.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/core/benchmark/synthetic/quick_scene.h"

namespace octacut {
namespace {

SyntheticScene SceneOf(MaterialKind kind,
                       const std::string& object = "lump",
                       bool fixed_to_camera = false) {
  SceneSpec spec = QuickScene(object, 160, 120, 8);
  spec.material = kind;
  spec.lighting.fixed_to_camera = fixed_to_camera;
  if (fixed_to_camera) {
    spec.rig.kind = RigKind::kTurntable;
    spec.rig.min_elevation = spec.rig.max_elevation = 20;
  }
  return MakeScene(spec, Context(2));
}

// The object's pixels well inside its outline.
cv::Mat Inside(const SyntheticView& view) {
  cv::Mat inside;
  cv::erode(view.mask == 255, inside, cv::Mat::ones(5, 5, CV_8UC1));
  return inside;
}

// The share of the object's pixels in which all channels are 255.
double BurntShare(const SyntheticScene& scene) {
  double burnt = 0;
  double all = 0;
  for (const SyntheticView& view : scene.views) {
    cv::Mat white;
    cv::inRange(view.image, cv::Scalar::all(255), cv::Scalar::all(255), white);
    const cv::Mat inside = Inside(view);
    burnt += cv::countNonZero(white & inside);
    all += cv::countNonZero(inside);
  }
  return burnt / all;
}

// How much the grey level of one place of the surface varies over the views
// that see it: the median over the places of the standard deviation.
double ViewDependence(const SyntheticScene& scene) {
  std::vector<double> deviations;
  for (const SyntheticPoint& point : scene.points) {
    std::vector<double> values;
    for (const auto& observation : point.observations) {
      const SyntheticView& view = scene.views[observation.view];
      const cv::Vec3b color =
          view.image.at<cv::Vec3b>(static_cast<int>(observation.pixel.y()),
                                   static_cast<int>(observation.pixel.x()));
      values.push_back(color[1]);
    }
    if (values.size() < 3) {
      continue;
    }
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) /
                        static_cast<double>(values.size());
    double squares = 0;
    for (const double value : values) {
      squares += (value - mean) * (value - mean);
    }
    deviations.push_back(
        std::sqrt(squares / static_cast<double>(values.size())));
  }
  std::sort(deviations.begin(), deviations.end());
  return deviations.empty() ? 0 : deviations[deviations.size() / 2];
}

TEST(MakeMaterial, DiffuseIsWhatIsGiven) {
  TextureOptions texture;
  texture.kind = TextureKind::kSpeckle;
  texture.scale = 0.3;
  LightingOptions lighting;
  lighting.specular = 0.4;
  const Material material =
      MakeMaterial(MaterialKind::kDiffuse, texture, lighting);
  EXPECT_EQ(material.texture.kind, TextureKind::kSpeckle);
  EXPECT_EQ(material.texture.scale, 0.3);
  EXPECT_EQ(material.lighting.specular, 0.4);
  EXPECT_EQ(material.lighting.lights.size(), lighting.lights.size());
  EXPECT_TRUE(material.finish.reflectance.isZero());
}

TEST(MakeMaterial, KeepsWhatTheLightsAreFixedTo) {
  LightingOptions lighting;
  lighting.fixed_to_camera = true;
  const Material porcelain =
      MakeMaterial(MaterialKind::kPorcelain, {}, lighting);
  EXPECT_TRUE(porcelain.lighting.fixed_to_camera);
  const std::vector<AreaLight> in_room =
      LampLights(porcelain.finish.environment);
  ASSERT_EQ(porcelain.lighting.lights.size(), in_room.size());
  for (size_t i = 0; i < in_room.size(); ++i) {
    // What is above in the room is above in the image, whose y is downward.
    const Eigen::Vector3d& direction = porcelain.lighting.lights[i].direction;
    EXPECT_NEAR(direction.y(), -in_room[i].direction.z(), 1e-12);
    EXPECT_NEAR(direction.z(), in_room[i].direction.y(), 1e-12);
  }
  for (const MaterialKind kind : {MaterialKind::kMetal,
                                  MaterialKind::kPorcelain,
                                  MaterialKind::kPlaster}) {
    EXPECT_NO_THROW(MakeMaterial(kind, {}, lighting).lighting.Check());
    EXPECT_NO_THROW(MakeMaterial(kind, {}, lighting).texture.Check());
  }
}

TEST(Material, MetalLooksDifferentFromEveryView) {
  const double metal = ViewDependence(SceneOf(MaterialKind::kMetal));
  EXPECT_GT(metal, 25);
  EXPECT_LT(ViewDependence(SceneOf(MaterialKind::kPlaster)), 4);
  EXPECT_GT(metal,
            2.5 * ViewDependence(SceneOf(MaterialKind::kDiffuse, "lump")));
}

TEST(Material, PorcelainBurnsOutInPart) {
  const double porcelain = BurntShare(SceneOf(MaterialKind::kPorcelain));
  EXPECT_GT(porcelain, 0.01);
  EXPECT_LT(porcelain, 0.35);
  EXPECT_EQ(BurntShare(SceneOf(MaterialKind::kPlaster)), 0);
}

TEST(Material, PlasterHasShadingButNoTexture) {
  // On a sphere all that changes from pixel to pixel quickly is texture.
  const SyntheticScene scene = SceneOf(MaterialKind::kPlaster, "sphere");
  for (const SyntheticView& view : scene.views) {
    cv::Mat grey, smooth, difference;
    cv::cvtColor(view.image, grey, cv::COLOR_BGR2GRAY);
    grey.convertTo(grey, CV_32F);
    cv::GaussianBlur(grey, smooth, {}, 1.5);
    cv::absdiff(grey, smooth, difference);
    cv::Mat inside = Inside(view);
    cv::erode(inside, inside, cv::Mat::ones(9, 9, CV_8UC1));
    EXPECT_LT(cv::mean(difference, inside)[0], 1);
    double low, high;
    cv::minMaxLoc(grey, &low, &high, nullptr, nullptr, inside);
    EXPECT_GT(high - low, 25);
    EXPECT_LT(high, 255);
  }
}

TEST(Material, SurroundingsTurnWithTheCameraWhereLightsDo) {
  // A sphere on a turntable mirrors the same to each camera, or not.
  const auto change = [](bool fixed_to_camera) {
    const SyntheticScene scene =
        SceneOf(MaterialKind::kMetal, "sphere", fixed_to_camera);
    return cv::norm(scene.views[0].image, scene.views[2].image, cv::NORM_L1) /
           static_cast<double>(scene.views[0].image.total() * 3);
  };
  EXPECT_LT(change(true), 0.5);
  EXPECT_GT(change(false), 5);
}

TEST(Material, GivesTheSameBytesForAnyNumberOfThreads) {
  SceneSpec spec = QuickScene("cup", 80, 60, 2);
  spec.reference.resolution = 40;
  for (const MaterialKind kind :
       {MaterialKind::kMetal, MaterialKind::kPorcelain}) {
    spec.material = kind;
    const SyntheticScene one = MakeScene(spec, Context(1));
    const SyntheticScene four = MakeScene(spec, Context(4));
    for (size_t i = 0; i < one.views.size(); ++i) {
      EXPECT_EQ(cv::norm(one.views[i].image, four.views[i].image, cv::NORM_INF),
                0);
    }
  }
}

TEST(Material, OnlyTheImageDependsOnIt) {
  const SyntheticScene metal = SceneOf(MaterialKind::kMetal);
  const SyntheticScene diffuse = SceneOf(MaterialKind::kDiffuse);
  EXPECT_EQ(metal.reference.positions, diffuse.reference.positions);
  for (size_t i = 0; i < metal.views.size(); ++i) {
    EXPECT_EQ(
        cv::norm(metal.views[i].mask, diffuse.views[i].mask, cv::NORM_INF), 0);
  }
}

}  // namespace
}  // namespace octacut
