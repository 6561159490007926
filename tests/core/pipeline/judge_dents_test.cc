#include "core/pipeline/judge_dents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "tests/core/extract/label_crust.h"
#include "tests/core/views/test_scene.h"

namespace octacut {
namespace {

using testing::TestScene;

constexpr int kDentLevel = 6;
constexpr double kDentDepth = 4;  // voxels
constexpr double kDentRadius = 9;
constexpr float kFarBehind = 100;

struct Finish {
  MaterialKind material = MaterialKind::kDiffuse;
  bool is_plain = false;
  double specular = 0;
  bool light_moves = false;  // with the camera
  bool operator<(const Finish& other) const {
    return std::tie(material, is_plain, specular, light_moves) <
           std::tie(other.material,
                    other.is_plain,
                    other.specular,
                    other.light_moves);
  }
};
constexpr Finish kPainted;
constexpr Finish kPlaster{.material = MaterialKind::kPlaster};
constexpr Finish kPlastic{.is_plain = true, .specular = 0.5};
constexpr Finish kOnTurntable{.is_plain = true, .light_moves = true};

// A photographed sphere, and labellings of it with a dent or a bulge.
struct DentSetting {
  TestScene test;

  explicit DentSetting(const Finish& of_sphere) {
    test = testing::MakeTestScene(
        testing::RenderOnce(of_sphere, [](const Finish& finish) {
          SceneSpec spec = testing::TestSpec("sphere", 240, 180, 20);
          spec.material = finish.material;
          if (finish.is_plain) {
            spec.texture.kind = TextureKind::kPlain;
          }
          spec.lighting.specular = finish.specular;
          if (finish.light_moves) {
            spec.lighting.fixed_to_camera = true;
            spec.lighting.lights = {{.direction = {0.3, -0.4, -1}}};
          }
          return spec;
        }));
  }

  // `shape` gets the signed distances to the sphere and to a ball that reaches
  // `depth` voxels into it.
  LabeledVoxels Label(
      double depth, const std::function<double(double, double)>& shape) const {
    const double voxel = test.VoxelSize(kDentLevel);
    // Towards a corner of the cube, where there is room.
    const Eigen::Vector3d ball = Eigen::Vector3d::Ones().normalized() *
                                 (0.8 + (kDentRadius - depth) * voxel);
    LabelledCrust labelled =
        LabelShape(kDentLevel, [&](const Eigen::Vector3d& unit) {
          const Eigen::Vector3d x = testing::ToWorld(test.region.cube, unit);
          return shape(x.norm() - 0.8,
                       (x - ball).norm() - kDentRadius * voxel) /
                 test.region.cube.edge;
        });
    return {std::move(labelled.crust), std::move(labelled.labels)};
  }

  LabeledVoxels Sphere() const {
    return Label(0, [](double sphere, double) { return sphere; });
  }

  LabeledVoxels Pitted() const {
    return Label(kDentDepth, [](double sphere, double ball) {
      return std::max(sphere, -ball);
    });
  }

  // The sphere with matter before it, so many voxels high.
  LabeledVoxels Bulged(double height) const {
    return Label(2 * kDentRadius - height, [](double sphere, double ball) {
      return std::min(sphere, ball);
    });
  }

  // `depth`: what all samples of all views have found, 0 for nothing; `detail`:
  // how much there is to match around each of them.
  SurfaceVerdict Judge(const LabeledVoxels& hull,
                       const LabeledVoxels& cut,
                       int num_threads = 2,
                       float depth = 0,
                       float detail = 1) const {
    std::vector<SweptDepthMap> maps(test.views.size());
    for (size_t i = 0; i < maps.size(); ++i) {
      maps[i].scale = 0.5f;
      maps[i].width = test.views[i].projection.width / 2;
      maps[i].height = test.views[i].projection.height / 2;
      maps[i].depths.assign(size_t(maps[i].width) * maps[i].height, depth);
      maps[i].detail.assign(maps[i].depths.size(), detail);
    }
    return JudgeDents(
        test.views, hull, cut, maps, RefineOptions(), Context(num_threads));
  }
};

struct Judgement {
  size_t num_samples = 0;
  double mean_confidence = 0;
};

Judgement MeanOf(const SurfaceVerdict& verdict) {
  const ReliableDepths& judged = verdict.depths;
  Judgement mean;
  for (size_t i = 0; i < judged.maps.size(); ++i) {
    for (size_t k = 0; k < judged.maps[i].depths.size(); ++k) {
      if (judged.maps[i].depths[k] > 0) {
        ++mean.num_samples;
        mean.mean_confidence += judged.confidence[i][k];
      }
    }
  }
  mean.mean_confidence /= double(std::max<size_t>(mean.num_samples, 1));
  return mean;
}

TEST(JudgeDents, RejectsPitsWhereTheHullIsRight) {
  for (const Finish& finish : {kPainted, kPlaster}) {
    const DentSetting setting(finish);
    const Judgement pit =
        MeanOf(setting.Judge(setting.Sphere(), setting.Pitted()));
    EXPECT_GT(pit.num_samples, 300u) << int(finish.material);
    EXPECT_LT(pit.mean_confidence, 0.3) << int(finish.material);
  }
}

TEST(JudgeDents, AcceptsWhatTheHullHasTooMuch) {
  const DentSetting setting(kPainted);
  const Judgement bulge =
      MeanOf(setting.Judge(setting.Bulged(kDentDepth), setting.Sphere()));
  EXPECT_GT(bulge.num_samples, 300u);
  EXPECT_GT(bulge.mean_confidence, 0.8);
}

TEST(JudgeDents, NeedDetailWhereTheObjectIsNotMatt) {
  const auto with_detail =
      [](const DentSetting& setting, float detail, float depth = 0) {
        return MeanOf(setting.Judge(
            setting.Bulged(kDentDepth), setting.Sphere(), 2, depth, detail));
      };
  for (const Finish& finish : {kPlaster, kOnTurntable}) {
    const DentSetting setting(finish);
    const Judgement matt = with_detail(setting, 1);
    EXPECT_GT(matt.mean_confidence, 0.3);
    EXPECT_EQ(with_detail(setting, 0).mean_confidence, matt.mean_confidence);
  }
  const DentSetting plastic(kPlastic);
  const Judgement glossy = with_detail(plastic, 1);
  EXPECT_GT(glossy.mean_confidence, 0.3);
  // Depths far behind the cut have no detail either.
  const Judgement plain = with_detail(plastic, 0.4f, kFarBehind);
  EXPECT_EQ(plain.num_samples, glossy.num_samples);
  EXPECT_NEAR(plain.mean_confidence, 0.4 * glossy.mean_confidence, 1e-3);
}

// Depths far behind the cut: of a pit they are doubted, since the hull is
// right; where hull and cut are both wrong, they may be right.
TEST(JudgeDents, LeavesDepthsBehindTheCutUnlessTheHullIsRight) {
  const DentSetting setting(kPainted);
  const LabeledVoxels sphere = setting.Sphere();
  const LabeledVoxels pitted = setting.Pitted();
  EXPECT_EQ(MeanOf(setting.Judge(sphere, pitted, 2, kFarBehind)).num_samples,
            MeanOf(setting.Judge(sphere, pitted)).num_samples);
  const LabeledVoxels bulged = setting.Bulged(2 * kDentDepth);
  const LabeledVoxels less = setting.Bulged(kDentDepth);
  const size_t num_judged = MeanOf(setting.Judge(bulged, less)).num_samples;
  EXPECT_GT(num_judged, 300u);
  EXPECT_LT(MeanOf(setting.Judge(bulged, less, 2, kFarBehind)).num_samples,
            num_judged / 4);
}

TEST(JudgeDents, FindsNoneWhereTheCutIsTheHull) {
  const DentSetting setting(kPainted);
  EXPECT_EQ(
      MeanOf(setting.Judge(setting.Sphere(), setting.Sphere())).num_samples,
      0u);
}

TEST(JudgeDents, FindsNoneInAnEmptyCut) {
  const DentSetting setting(kPainted);
  LabeledVoxels empty = setting.Sphere();
  std::fill(empty.labels.begin(), empty.labels.end(), FaceLabels{0});
  EXPECT_EQ(MeanOf(setting.Judge(setting.Sphere(), empty)).num_samples, 0u);
}

TEST(JudgeDents, IsTheSameForAnyNumberOfThreads) {
  const DentSetting setting(kPlaster);
  const LabeledVoxels pitted = setting.Pitted();
  const SurfaceVerdict one = setting.Judge(setting.Sphere(), pitted, 1);
  const SurfaceVerdict three = setting.Judge(setting.Sphere(), pitted, 3);
  for (size_t i = 0; i < one.depths.maps.size(); ++i) {
    EXPECT_EQ(one.depths.maps[i].depths, three.depths.maps[i].depths) << i;
    EXPECT_EQ(one.depths.confidence[i], three.depths.confidence[i]) << i;
    EXPECT_EQ(one.in_pit[i], three.in_pit[i]) << i;
  }
}

}  // namespace
}  // namespace octacut
