// Colours of a texture where the paint is known: the bundled example's object.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/base/srgb.h"
#include "core/benchmark/synthetic/texture.h"
#include "core/texture/pixel_sampler.h"
#include "core/texture/texture_mesh.h"
#include "tests/core/benchmark/synthetic/quick_scene.h"
#include "tests/core/views/render_once.h"

namespace octacut {
namespace {

Photographs PhotographsOfScene(const SyntheticScene& synthetic) {
  const Scene scene = ToScene(synthetic);
  Photographs photographs;
  for (const View& view : scene.views) {
    photographs.poses.push_back({view.name, view.camera, view.cam_from_world});
  }
  photographs.load = [views = scene.views](size_t i) {
    return Photograph{views[i].image, views[i].mask};
  };
  return photographs;
}

// Shares of red, green and blue, which white light does not change, 0 .. 255.
Eigen::Vector3d Chroma(const Eigen::Vector3d& linear) {
  return 255 * linear / std::max(1e-6, linear.sum());
}

// Points spread over a triangle: weights of its corners.
std::vector<Eigen::Vector3d> SpreadWeights() {
  constexpr int kSide = 6;
  std::vector<Eigen::Vector3d> all;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; i + j < kSide; ++j) {
      const double a = (i + 1.0 / 3) / kSide;
      const double b = (j + 1.0 / 3) / kSide;
      all.emplace_back(1 - a - b, a, b);
    }
  }
  return all;
}

// Linear red, green and blue of the texture at a point of a triangle.
Eigen::Vector3d TexelAt(const TexturedMesh& textured,
                        size_t f,
                        const Eigen::Vector3d& weights) {
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  for (int k = 0; k < 3; ++k) {
    uv += weights[k] * textured.texcoords[f][size_t(k)].cast<double>();
  }
  const cv::Mat& page = textured.pages[textured.PageOf(f)].color;
  const Eigen::Vector3f bgr =
      SamplePixels(page, uv.x() * page.cols, uv.y() * page.rows);
  return (bgr.reverse().cast<double>() / 255).unaryExpr(&DecodeSrgb);
}

struct ChromaErrors {
  double mean = 0;
  double of_95_percent = 0;
};

// Compares mean colours of triangles, which are some pixels across: finer
// detail of the paint is not in the photographs.
ChromaErrors Measure(const SyntheticScene& scene, const TexturedMesh& mesh) {
  const std::vector<Eigen::Vector3d> points = SpreadWeights();
  std::vector<double> errors;
  for (size_t f = 0; f < mesh.mesh.triangles.size(); ++f) {
    Eigen::Vector3d texture = Eigen::Vector3d::Zero();
    Eigen::Vector3d paint = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& weights : points) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k) {
        point +=
            weights[k] * mesh.mesh.positions[mesh.mesh.triangles[f][size_t(k)]];
      }
      texture += TexelAt(mesh, f, weights);
      paint +=
          TextureColor(scene.spec.texture, point.cast<float>()).cast<double>();
    }
    errors.push_back((Chroma(texture) - Chroma(paint)).cwiseAbs().mean());
  }
  std::sort(errors.begin(), errors.end());
  ChromaErrors result;
  for (const double error : errors) {
    result.mean += error / double(errors.size());
  }
  result.of_95_percent = errors[errors.size() * 95 / 100];
  return result;
}

// White lights, whose shading the shares of colours do not have. The largest
// errors are those of dark paint in the shade, of which the eight bits of a
// photograph have few levels.
SyntheticScene WhiteLights(double noise) {
  SyntheticScene scene =
      testing::RenderOnce(std::string("example"), [](const auto& object) {
        SceneSpec spec = QuickScene(object, 640, 480, 20);
        for (AreaLight& light : spec.lighting.lights) {
          light.color.setConstant(light.color.mean());
        }
        spec.lighting.ambient.setConstant(0.43f);
        return spec;
      });
  DegradeOptions degrade;
  degrade.pixel_noise = noise;
  for (size_t i = 0; i < scene.views.size(); ++i) {
    DegradeImage(degrade, HashBits(scene.spec.seed, i), scene.views[i].image);
  }
  return scene;
}

void ExpectErrorsBelow(double mean, double of_95_percent, double noise) {
  const SyntheticScene scene = WhiteLights(noise);
  const TexturingResult result =
      TextureMesh(scene.reference, PhotographsOfScene(scene), {}, Context(1));
  EXPECT_LT(result.summary.unseen_area, 0.01);
  const ChromaErrors errors = Measure(scene, result.textured);
  EXPECT_LT(errors.mean, mean);
  EXPECT_LT(errors.of_95_percent, of_95_percent);
}

TEST(KnownAlbedo, TexturesHaveTheColorsOfTheExamplesPaint) {
  ExpectErrorsBelow(1.8, 6.5, 0);
}

TEST(KnownAlbedo, NoiseOfPhotographsAveragesOut) {
  ExpectErrorsBelow(3.5, 10.5, 5);
}

}  // namespace
}  // namespace octacut
