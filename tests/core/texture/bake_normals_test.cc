#include "core/texture/bake_normals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/base/with_threads.h"
#include "core/texture/texture_mesh.h"
#include "tests/core/texture/bumpy_sphere.h"
#include "tests/core/texture/small_sphere.h"

namespace octacut {
namespace {

using testing::BumpyNormal;
using testing::BumpySphere;
using testing::Degrees;
using ::testing::HasSubstr;
using testing::PhotographsOf;
using testing::SmallSphere;

// A smooth sphere whose lower half no photograph shows, so that there are
// charts of both kinds.
class BakeNormalsTest : public ::testing::Test {
 protected:
  static TexturingResult Texture(const Context& context) {
    TexturingOptions options;
    options.texture_size = 256;  // several pages
    return TextureMesh(
        SmallSphere(4),
        PhotographsOf({{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}}, 160),
        options,
        context);
  }
};

// Points of triangles, in order: their centres and near their corners.
const std::array<Eigen::Vector2f, 4> kPoints = {
    Eigen::Vector2f(0.33f, 0.33f), {0.1f, 0.1f}, {0.8f, 0.1f}, {0.1f, 0.8f}};

TEST_F(BakeNormalsTest, GivesTheNormalsOfABumpySphere) {
  TexturingResult result = Texture(Context(1));
  const NormalMapSummary summary =
      BakeNormals(BumpySphere(), result.layout, Context(1), &result.textured);
  EXPECT_EQ(summary.num_texels, result.summary.num_texels);
  EXPECT_EQ(summary.num_missed, 0u);
  EXPECT_GT(summary.mean_angle, 1);
  const TexturedMesh& textured = result.textured;
  double sum = 0;
  double of_smooth = 0;
  size_t count = 0;
  for (uint32_t f = 0; f < textured.mesh.triangles.size(); ++f) {
    const bool is_unseen =
        result.layout.charts.charts[textured.charts[f]].view == kNoView;
    for (const Eigen::Vector2f& point : kPoints) {
      Eigen::Vector3d u = Eigen::Vector3d::Zero();
      for (size_t k = 0; k < 3; ++k) {
        const float weight =
            k == 0 ? 1 - point.sum() : point[Eigen::Index(k) - 1];
        u += double(weight) *
             textured.mesh.positions[textured.mesh.triangles[f][k]];
      }
      u.normalize();
      const Eigen::Vector3d normal =
          MappedNormal(textured, {0, f, point}).cast<double>();
      const double angle = Degrees(normal, BumpyNormal(u));
      // Unseen charts have a quarter of the texels, one of which is as wide as
      // a fifth of a bump.
      EXPECT_LT(angle, is_unseen ? 2.5 : 1) << f << " at " << u.transpose();
      sum += angle;
      of_smooth += Degrees(u, BumpyNormal(u));
      ++count;
    }
  }
  EXPECT_LT(sum / double(count), 0.4);
  EXPECT_GT(of_smooth / double(count), 5 * sum / double(count));
}

// How a point of the surface moves as its texel moves to the right and up,
// which is toward smaller v.
Eigen::Matrix<float, 3, 2> MovesOnPage(const TexturedMesh& mesh, size_t face) {
  const auto& corners = mesh.mesh.triangles[face];
  const auto& uvs = mesh.texcoords[face];
  const cv::Mat& page = mesh.pages[mesh.PageOf(face)].color;
  Eigen::Matrix<float, 3, 2> edges;
  Eigen::Matrix2f texels;
  for (int k = 0; k < 2; ++k) {
    edges.col(k) = (mesh.mesh.positions[corners[size_t(k) + 1]] -
                    mesh.mesh.positions[corners[0]])
                       .cast<float>();
    const Eigen::Vector2f step = uvs[size_t(k) + 1] - uvs[0];
    texels.col(k) << step.x() * float(page.cols), -step.y() * float(page.rows);
  }
  return edges * texels.inverse();
}

TEST_F(BakeNormalsTest, TangentsFollowTheConventionsOfGltf) {
  TexturingResult result = Texture(Context(1));
  BakeNormals(BumpySphere(), result.layout, Context(1), &result.textured);
  const TexturedMesh& textured = result.textured;
  ASSERT_EQ(textured.tangents.size(), textured.mesh.triangles.size());
  for (size_t f = 0; f < textured.tangents.size(); ++f) {
    const auto& corners = textured.mesh.triangles[f];
    const Eigen::Matrix<float, 3, 2> moves = MovesOnPage(textured, f);
    for (size_t k = 0; k < 3; ++k) {
      const Eigen::Vector4f& tangent = textured.tangents[f][k];
      const Eigen::Vector3f along = tangent.head<3>();
      const Eigen::Vector3f& normal = textured.mesh.normals[corners[k]];
      EXPECT_NEAR(along.norm(), 1, 1e-5);
      EXPECT_EQ(std::abs(tangent[3]), 1);
      EXPECT_NEAR(along.dot(normal), 0, 1e-4);
      EXPECT_GT(along.dot(moves.col(0).normalized()), 0.9f) << f;
      const Eigen::Vector3f up = tangent[3] * normal.cross(along);
      EXPECT_GT(up.dot(moves.col(1)), 0) << f;
    }
  }
}

TEST_F(BakeNormalsTest, GivesTheSameBytesForAnyNumberOfThreads) {
  TexturingResult one = Texture(Context(1));
  TexturingResult many = Texture(Context(1));
  const IndexedMesh full = BumpySphere();
  const NormalMapSummary a =
      BakeNormals(full, one.layout, Context(1), &one.textured);
  NormalMapSummary b;
  WithThreads(4, [&] {
    b = BakeNormals(full, many.layout, Context(4), &many.textured);
  });
  EXPECT_EQ(a.mean_angle, b.mean_angle);
  EXPECT_EQ(one.textured.tangents, many.textured.tangents);
  for (size_t page = 0; page < one.textured.pages.size(); ++page) {
    EXPECT_EQ(cv::norm(one.textured.pages[page].normals,
                       many.textured.pages[page].normals,
                       cv::NORM_INF),
              0);
  }
}

TEST_F(BakeNormalsTest, RefusesAMeshThatIsElsewhere) {
  TexturingResult result = Texture(Context(1));
  IndexedMesh moved = BumpySphere();
  for (Eigen::Vector3d& p : moved.positions) {
    p *= 1.2;
  }
  const auto message = [&](const IndexedMesh& full) -> std::string {
    try {
      BakeNormals(full, result.layout, Context(1), &result.textured);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message(moved), HasSubstr("are both in the same frame?"));
  EXPECT_THAT(message({}), HasSubstr("has no triangles"));
}

}  // namespace
}  // namespace octacut
