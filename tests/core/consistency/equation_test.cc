// phi against HK06 eq. (1) computed directly, in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/consistency/patch.h"
#include "tests/core/consistency/sphere_scene.h"
#include "tests/core/grid/codes_of.h"

namespace octacut {
namespace {

using testing::MakeSphereScene;
using testing::SphereScene;

// c[j][i]: colours of the samples i of view j, with the views' weights.
struct Samples {
  std::vector<double> weights;
  std::vector<std::vector<Eigen::Vector3d>> colors;
  // A view shows hardly any background: rounding decides if it is left out.
  bool is_doubtful = false;
};

// The patch on the paraboloid, sampled point by point.
Samples SamplePatch(const SphereScene& sphere,
                    const Visibility::Selection& selection,
                    const Eigen::Vector3d& center,
                    const SurfaceShape& shape,
                    int radius) {
  const Eigen::Vector3d normal = shape.normal.cast<double>();
  int axis;
  normal.cwiseAbs().minCoeff(&axis);
  const Eigen::Vector3d u =
      normal.cross(Eigen::Vector3d::Unit(axis)).normalized();
  const Eigen::Vector3d v = normal.cross(u);
  const double spacing = 1.0 / (1 << SphereScene::kLevel);
  Samples samples;
  for (int k = 0; k < selection.count; ++k) {
    const size_t number = selection.views[k].view;
    const View& view = sphere.test.scene.views[number];
    const double depth = (view.cam_from_world *
                          testing::ToWorld(sphere.test.region.cube, center))
                             .z() /
                         sphere.test.region.cube.edge;
    const PyramidLevel& level =
        sphere.test.views[number].pyramid.LevelForFootprint(
            float((view.camera.fx + view.camera.fy) / 2 * spacing / depth));
    std::vector<Eigen::Vector3d> colors;
    int num_background = 0;
    int num_mixed = 0;
    for (int j = -radius; j <= radius; ++j) {
      for (int i = -radius; i <= radius; ++i) {
        const Eigen::Vector3d point =
            center + spacing * (double(i) * u + double(j) * v -
                                shape.curvature / 2 * (i * i + j * j) * normal);
        const Eigen::Vector2d pixel = view.camera.Project(
            view.cam_from_world *
            testing::ToWorld(sphere.test.region.cube, point));
        const Float4 color = level.Sample(float(pixel.x()), float(pixel.y()));
        colors.emplace_back(color[0], color[1], color[2]);
        num_background += color[3] < 127.5f;
        num_mixed += color[3] < 255;
      }
    }
    samples.is_doubtful |= num_mixed > 0 && num_background <= 2;
    if (num_background == 0) {
      samples.weights.push_back(selection.views[k].weight);
      samples.colors.push_back(colors);
    }
  }
  return samples;
}

// Less its mean, its chroma weighted, of unit length with the noise taken into
// account; returns how much of the contrast is not noise.
double Normalize(const ConsistencyOptions& options,
                 std::vector<Eigen::Vector3d>* colors) {
  const double noise = options.pixel_noise;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& color : *colors) {
    mean += color / double(colors->size());
  }
  double contrast = 0;
  for (Eigen::Vector3d& color : *colors) {
    color -= mean;
    const Eigen::Vector3d grey = Eigen::Vector3d::Constant(color.mean());
    color = grey + options.chroma_weight * (color - grey);
    contrast += color.squaredNorm();
  }
  const double total = contrast + 3 * double(colors->size()) * noise * noise;
  for (Eigen::Vector3d& color : *colors) {
    color /= std::sqrt(total);
  }
  return contrast / total;
}

// HK06 eq. (1), summed over the colour channels.
double EquationOne(const Samples& samples) {
  double total = 0;  // W
  for (const double w : samples.weights) {
    total += w;
  }
  double phi = 0;
  for (size_t i = 0; i < samples.colors[0].size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      double square = 0;
      double mean = 0;
      for (size_t j = 0; j < samples.weights.size(); ++j) {
        const double c = samples.colors[j][i][channel];
        square += samples.weights[j] * c * c / total;
        mean += samples.weights[j] * c / total;
      }
      phi += square - mean * mean;
    }
  }
  return phi;
}

double NormalizedVariance(Samples samples, const ConsistencyOptions& options) {
  double total = 0;
  double squares = 0;
  double reliability = 0;
  for (size_t j = 0; j < samples.weights.size(); ++j) {
    const double w = samples.weights[j];
    reliability += w * Normalize(options, &samples.colors[j]);
    total += w;
    squares += w * w;
  }
  const double views = total * total / squares;  // effective number
  return EquationOne(samples) * views / std::max(views - 1, 0.5) +
         (1 - reliability / total) * options.neutral;
}

double Ncc(Samples samples, const ConsistencyOptions& options) {
  for (auto& colors : samples.colors) {
    Normalize(options, &colors);
  }
  double sum = 0;
  double weights = 0;
  for (size_t j = 0; j < samples.weights.size(); ++j) {
    for (size_t k = j + 1; k < samples.weights.size(); ++k) {
      double correlation = 0;
      for (size_t i = 0; i < samples.colors[j].size(); ++i) {
        correlation += samples.colors[j][i].dot(samples.colors[k][i]);
      }
      const double w = samples.weights[j] * samples.weights[k];
      sum += w * correlation;
      weights += w;
    }
  }
  return (1 - sum / weights) / 2;
}

double Variance(const Samples& samples) {
  return std::sqrt(EquationOne(samples) /
                   (3 * double(samples.colors[0].size()))) /
         64;
}

TEST(PhotoConsistency, IsEquationOne) {
  const SphereScene sphere = MakeSphereScene();
  const Visibility visibility = sphere.EstimateVisibility(sphere.test.views);
  for (const int radius : {1, 2, 3}) {
    ConsistencyOptions options;
    options.patch_radius = radius;
    options.min_patch_pixels = 0;
    options.neutral = 0.4;
    options.measure = ConsistencyMeasure::kNormalizedVariance;
    const std::vector<float> normalized = sphere.Estimate(options).phi;
    options.measure = ConsistencyMeasure::kNcc;
    const std::vector<float> ncc = sphere.Estimate(options).phi;
    options.measure = ConsistencyMeasure::kVariance;
    const std::vector<float> variance = sphere.Estimate(options).phi;
    size_t num_compared = 0;
    double error = 0;
    sphere.shell.ForEach([&](VoxelGrid::Index index, MortonCode code) {
      if (index % 37 != 0) {
        return;
      }
      const Eigen::Vector3f center =
          VoxelCenter(DecodeMorton(code), SphereScene::kLevel);
      const Samples samples =
          SamplePatch(sphere,
                      visibility.Select(center, sphere.shapes[index].normal),
                      center.cast<double>(),
                      sphere.shapes[index],
                      radius);
      if (samples.is_doubtful) {
        return;
      }
      if (samples.weights.size() < 2) {
        EXPECT_EQ(normalized[index], 0.4f);
        return;
      }
      ++num_compared;
      // The code under test takes the projection of a patch for affine.
      const auto compare = [&](double phi, double expected) {
        expected = std::clamp(expected, 0.0, 1.0);
        EXPECT_NEAR(phi, expected, 0.1) << index;
        error += std::abs(phi - expected);
      };
      compare(normalized[index], NormalizedVariance(samples, options));
      compare(ncc[index], Ncc(samples, options));
      compare(variance[index], Variance(samples));
    });
    EXPECT_GT(num_compared, 200u);
    EXPECT_LT(error / double(3 * num_compared), 0.004);
  }
}

TEST(Patch, LeavesOutViewsThatShowBackground) {
  SphereScene sphere = MakeSphereScene();
  const Visibility visibility = sphere.EstimateVisibility(sphere.test.views);
  // One at the middle of the side toward the first view.
  const Eigen::Vector3f direction =
      (sphere.test.views[0].projection.center - Eigen::Vector3f::Constant(0.5f))
          .normalized();
  VoxelGrid::Index index = 0;
  for (size_t i = 0; i < sphere.shapes.size(); ++i) {
    if (sphere.shapes[i].normal.dot(direction) >
        sphere.shapes[index].normal.dot(direction)) {
      index = VoxelGrid::Index(i);
    }
  }
  const Eigen::Vector3f center = VoxelCenter(
      DecodeMorton(CodesOf(sphere.shell)[index]), SphereScene::kLevel);
  const Visibility::Selection selection =
      visibility.Select(center, sphere.shapes[index].normal);
  ASSERT_GE(selection.count, 3);
  const auto sample = [&] {
    Patch patch;
    patch.Sample(sphere.test.views,
                 selection,
                 {center,
                  sphere.shapes[index].normal,
                  0,
                  1.0f / (1 << SphereScene::kLevel),
                  2});
    EXPECT_EQ(patch.NumSamples(), 25);
    return patch.NumViews();
  };
  EXPECT_EQ(sample(), selection.count);
  View& view = sphere.test.scene.views[selection.views[1].view];
  view.mask = cv::Mat::zeros(view.mask.size(), CV_8UC1);
  sphere.test.views =
      PrepareViews(sphere.test.scene, sphere.test.region.cube, Context(1));
  EXPECT_EQ(sample(), selection.count - 1);
}

}  // namespace
}  // namespace octacut
