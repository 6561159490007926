#include "core/texture/texture_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/with_threads.h"
#include "core/texture/pixel_sampler.h"
#include "tests/core/texture/small_sphere.h"

namespace octacut {
namespace {

using testing::AllAround;
using ::testing::HasSubstr;
using testing::Paint;
using testing::PhotographsOf;
using testing::SmallSphere;

constexpr int kSquareSize = 160;

// The texture's colour in the middle of a triangle.
Eigen::Vector3f ColorAtCenter(const TexturedMesh& textured, size_t f) {
  const auto& uvs = textured.texcoords[f];
  const Eigen::Vector2f uv = (uvs[0] + uvs[1] + uvs[2]) / 3;
  const cv::Mat& page = textured.pages[textured.PageOf(f)].color;
  return SamplePixels(
      page, double(uv.x()) * page.cols, double(uv.y()) * page.rows);
}

// With detail that a blur of some pixels removes.
Eigen::Vector3f FinePaint(const Eigen::Vector3d& p) {
  return Paint(p) + Eigen::Vector3f::Constant(float(
                        40 * std::sin(40 * p.x()) * std::sin(40 * p.y() + 1) +
                        40 * std::sin(40 * p.z()) * std::sin(40 * p.y() + 2)));
}

// Mean difference from the paint over all triangles, grey levels.
double MeanError(const TexturedMesh& textured) {
  double sum = 0;
  for (size_t f = 0; f < textured.mesh.triangles.size(); ++f) {
    const auto& corners = textured.mesh.triangles[f];
    const Eigen::Vector3d center = (textured.mesh.positions[corners[0]] +
                                    textured.mesh.positions[corners[1]] +
                                    textured.mesh.positions[corners[2]])
                                       .normalized();
    sum +=
        double((ColorAtCenter(textured, f) - Paint(center)).cwiseAbs().sum()) /
        3;
  }
  return sum / double(textured.mesh.triangles.size());
}

std::string ErrorOf(const IndexedMesh& mesh,
                    const Photographs& photographs,
                    const TexturingOptions& options = {}) {
  try {
    TextureMesh(mesh, photographs, options, Context(1));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(TextureMesh, GivesBackThePaint) {
  const IndexedMesh sphere = SmallSphere(4);
  const Photographs photographs = PhotographsOf(AllAround(), kSquareSize);
  for (const ViewBlending blending :
       {ViewBlending::kBest, ViewBlending::kMedian}) {
    TexturingOptions options;
    options.view_blending = blending;
    const TexturingResult result =
        TextureMesh(sphere, photographs, options, Context(1));
    EXPECT_EQ(result.summary.num_unseen, 0u);
    EXPECT_EQ(result.summary.num_unfilled_texels, 0u);
    // Red is the background's colour: bleeding would show.
    EXPECT_LT(MeanError(result.textured), 2);
  }
}

TEST(TextureMesh, LevelsExposures) {
  std::vector<float> gains;
  for (size_t i = 0; i < 14; ++i) {
    gains.push_back(i % 2 == 0 ? 0.9f : 1.1f);
  }
  const TexturingResult result =
      TextureMesh(SmallSphere(4),
                  PhotographsOf(AllAround(), kSquareSize, gains),
                  {},
                  Context(1));
  EXPECT_GT(result.summary.seams.before, 5);
  EXPECT_LT(result.summary.seams.after, 0.3 * result.summary.seams.before);
  EXPECT_LT(MeanError(result.textured), 5);
}

TEST(TextureMesh, VotesAPasserByOut) {
  Photographs photographs = PhotographsOf(AllAround(), kSquareSize);
  // A white disc before the middle of the first photograph, which would be the
  // best view of what is behind it.
  photographs.load = [load = photographs.load](size_t i) {
    Photograph photograph = load(i);
    photograph.image = photograph.image.clone();
    if (i == 0) {
      cv::circle(photograph.image,
                 {kSquareSize / 2, kSquareSize / 2},
                 12,
                 cv::Scalar(255, 255, 255),
                 cv::FILLED);
    }
    return photograph;
  };
  const TexturingResult result =
      TextureMesh(SmallSphere(4), photographs, {}, Context(1));
  const TexturedMesh& textured = result.textured;
  size_t num_behind = 0;
  for (size_t f = 0; f < textured.mesh.triangles.size(); ++f) {
    const Eigen::Vector3d& p =
        textured.mesh.positions[textured.mesh.triangles[f][0]];
    if (p.x() > 0.995) {
      ++num_behind;
      EXPECT_LT((ColorAtCenter(textured, f) - Paint(p)).cwiseAbs().maxCoeff(),
                40);
    }
  }
  EXPECT_GT(num_behind, 5u);
}

TEST(TextureMesh, PrefersSharpPhotographs) {
  const Photographs sharp =
      PhotographsOf(AllAround(), kSquareSize, {}, FinePaint);
  Photographs blurred = sharp;
  blurred.load = [load = sharp.load](size_t i) {
    Photograph photograph = load(i);
    if (i == 0) {
      // Where the object ends, it keeps its colours: only sharpness is lost.
      cv::Mat detail;
      cv::GaussianBlur(photograph.image, detail, {}, 4);
      cv::Mat inside;
      cv::erode(photograph.mask, inside, {}, {-1, -1}, 12);
      photograph.image = photograph.image.clone();
      detail.copyTo(photograph.image, inside);
    }
    return photograph;
  };
  const IndexedMesh sphere = SmallSphere(4);
  const auto triangles_of_first = [&](const Photographs& photographs) {
    return TextureMesh(sphere, photographs, {}, Context(1))
        .summary.triangles_of_view[0];
  };
  const size_t before = triangles_of_first(sharp);
  EXPECT_GT(before, 50u);
  EXPECT_LT(2 * triangles_of_first(blurred), before);
}

TEST(TextureMesh, TheMedianRemovesHighlights) {
  // A lamp at each camera: its highlight is in the middle of each photograph,
  // and elsewhere on the object in the next.
  Photographs photographs = PhotographsOf(AllAround(), kSquareSize);
  photographs.load = [load = photographs.load](size_t i) {
    Photograph photograph = load(i);
    photograph.image = photograph.image.clone();
    cv::circle(photograph.image,
               {kSquareSize / 2, kSquareSize / 2},
               8,
               cv::Scalar(255, 255, 255),
               cv::FILLED);
    return photograph;
  };
  TexturingOptions options;
  options.view_blending = ViewBlending::kMedian;
  EXPECT_LT(
      MeanError(TextureMesh(SmallSphere(4), photographs, options, Context(1))
                    .textured),
      2);
}

TEST(TextureMesh, FillsWhatIsNotSeen) {
  // From above alone: the lower half is not seen.
  const TexturingResult result = TextureMesh(
      SmallSphere(4),
      PhotographsOf({{0, 0, 1}, {0.5, 0, 1}, {0, 0.5, 1}}, kSquareSize),
      {},
      Context(1));
  EXPECT_GT(result.summary.unseen_area, 0.3);
  EXPECT_LT(result.summary.unseen_area, 0.7);
  EXPECT_EQ(result.summary.num_unfilled_texels, 0u);
  for (size_t f = 0; f < result.textured.mesh.triangles.size(); ++f) {
    const Eigen::Vector3f color = ColorAtCenter(result.textured, f);
    EXPECT_GT(color.minCoeff(), 40);  // neither black nor the background's red
    EXPECT_LT(color.maxCoeff(), 200);
  }
}

TEST(TextureMesh, GivesTheSameBytesForAnyNumberOfThreads) {
  const IndexedMesh sphere = SmallSphere(4);
  const Photographs photographs = PhotographsOf(AllAround(), kSquareSize);
  for (const ViewBlending blending :
       {ViewBlending::kBest, ViewBlending::kMedian}) {
    const auto run = [&](int num_threads) {
      TexturingOptions options;
      options.view_blending = blending;
      TexturingResult result;
      WithThreads(num_threads, [&] {
        result =
            TextureMesh(sphere, photographs, options, Context(num_threads));
      });
      return result.textured;
    };
    const TexturedMesh one = run(1);
    const TexturedMesh two = run(2);
    EXPECT_EQ(one.charts, two.charts);
    EXPECT_EQ(one.texcoords, two.texcoords);
    ASSERT_EQ(one.pages.size(), two.pages.size());
    for (size_t p = 0; p < one.pages.size(); ++p) {
      ASSERT_EQ(one.pages[p].color.size(), two.pages[p].color.size());
      EXPECT_EQ(cv::norm(one.pages[p].color, two.pages[p].color), 0);
    }
  }
}

TEST(TextureMesh, SpreadsOverPagesAndScalesTexels) {
  const IndexedMesh sphere = SmallSphere(4);
  const Photographs photographs = PhotographsOf(AllAround(), kSquareSize);
  const TexturingResult whole =
      TextureMesh(sphere, photographs, {}, Context(1));
  TexturingOptions options;
  options.texture_size = 128;
  const TexturingResult pages =
      TextureMesh(sphere, photographs, options, Context(1));
  EXPECT_GT(pages.summary.num_pages, 1u);
  EXPECT_LT(MeanError(pages.textured), 2);
  options.texture_size = 8192;
  options.texel_scale = 0.5;
  const TexturingResult half =
      TextureMesh(sphere, photographs, options, Context(1));
  EXPECT_NEAR(double(half.summary.num_texels),
              0.25 * double(whole.summary.num_texels),
              0.03 * double(whole.summary.num_texels));
}

TEST(TextureMesh, RefusesWhatCannotBeTextured) {
  const IndexedMesh sphere = SmallSphere(3);
  const Photographs photographs = PhotographsOf(AllAround(), kSquareSize);
  EXPECT_THAT(ErrorOf({}, photographs), HasSubstr("no triangles"));
  EXPECT_THAT(ErrorOf(sphere, {}), HasSubstr("no photographs"));
  IndexedMesh elsewhere = sphere;
  for (Eigen::Vector3d& position : elsewhere.positions) {
    position += Eigen::Vector3d(100, 40, 0);
  }
  EXPECT_THAT(ErrorOf(elsewhere, photographs), HasSubstr("frame"));
  TexturingOptions options;
  options.texture_size = 64;
  options.max_pages = 1;
  EXPECT_THAT(ErrorOf(sphere, photographs, options),
              HasSubstr("max_pages = 1: the texture needs"));
}

}  // namespace
}  // namespace octacut
