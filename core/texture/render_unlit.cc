#include "core/texture/render_unlit.h"

#include <functional>
#include <opencv2/core.hpp>

#include "core/base/parallel_pixels.h"
#include "core/base/srgb.h"
#include "core/raycast/render.h"
#include "core/texture/bake_normals.h"
#include "core/texture/pixel_sampler.h"

namespace octacut {
namespace {

constexpr int kPixelSamplesASide = 2;

Eigen::Vector3f HitWeights(const RayScene::Hit& hit) {
  return {1 - hit.barycentric.sum(), hit.barycentric.x(), hit.barycentric.y()};
}

UnlitPicture Render(
    const RayScene& rays,
    const PhotographPose& pose,
    const Context& context,
    const std::function<Eigen::Vector3f(const RayScene::Hit&)>& color_at) {
  const PinholeCamera& camera = pose.camera;
  const Eigen::Matrix3d to_world = pose.cam_from_world.rotation.transpose();
  const Eigen::Vector3d center = pose.Center();
  UnlitPicture picture;
  picture.color = cv::Mat(camera.height, camera.width, CV_8UC3, cv::Scalar());
  picture.covered =
      cv::Mat(camera.height, camera.width, CV_8UC1, cv::Scalar(0));
  ParallelPixels(context, camera.width, camera.height, [&](int x, int y) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    int count = 0;
    for (int j = 0; j < kPixelSamplesASide; ++j) {
      for (int i = 0; i < kPixelSamplesASide; ++i) {
        const Eigen::Vector3d direction =
            to_world * camera.Unproject({x + (i + 0.5) / kPixelSamplesASide,
                                         y + (j + 0.5) / kPixelSamplesASide});
        if (const auto hit = rays.FirstHit(center, direction)) {
          sum += color_at(*hit);
          ++count;
        }
      }
    }
    if (count > 0) {
      for (int c = 0; c < 3; ++c) {
        picture.color.at<cv::Vec3b>(y, x)[c] =
            cv::saturate_cast<uint8_t>(sum[c] / float(count));
      }
    }
    picture.covered.at<uint8_t>(y, x) =
        count == kPixelSamplesASide * kPixelSamplesASide ? 255 : 0;
  });
  return picture;
}

}  // namespace

UnlitPicture RenderTexture(const TexturedMesh& mesh,
                           const RayScene& rays,
                           const PhotographPose& pose,
                           const Context& context) {
  return Render(rays, pose, context, [&](const RayScene::Hit& hit) {
    const Eigen::Vector3f weights = HitWeights(hit);
    Eigen::Vector2f uv = Eigen::Vector2f::Zero();
    for (int k = 0; k < 3; ++k) {
      uv += weights[k] * mesh.texcoords[hit.triangle][size_t(k)];
    }
    const cv::Mat& page = mesh.pages[mesh.PageOf(hit.triangle)].color;
    return SamplePixels(
        page, double(uv.x()) * page.cols, double(uv.y()) * page.rows);
  });
}

UnlitPicture RenderVertexColors(const IndexedMesh& mesh,
                                const RayScene& rays,
                                const PhotographPose& pose,
                                const Context& context) {
  return Render(rays, pose, context, [&](const RayScene::Hit& hit) {
    const Eigen::Vector3f weights = HitWeights(hit);
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    for (int k = 0; k < 3 && !mesh.colors.empty(); ++k) {
      const auto& rgb = mesh.colors[mesh.triangles[hit.triangle][size_t(k)]];
      color += weights[k] *
               Eigen::Vector3f(float(rgb[2]), float(rgb[1]), float(rgb[0]));
    }
    return color;
  });
}

cv::Mat RenderRelit(const TexturedMesh& mesh,
                    const RayScene& rays,
                    const PhotographPose& pose,
                    const Context& context) {
  RenderOptions white;
  white.clay_color = Eigen::Vector3d::Ones();
  if (!mesh.tangents.empty()) {
    white.normal_at = [&mesh](const RayScene::Hit& hit) {
      return MappedNormal(mesh, hit);
    };
  }
  cv::Mat picture = RenderShaded(
      mesh.mesh, rays, pose.camera, pose.cam_from_world, white, context);
  const UnlitPicture unlit = RenderTexture(mesh, rays, pose, context);
  for (int y = 0; y < picture.rows; ++y) {
    for (int x = 0; x < picture.cols; ++x) {
      if (unlit.covered.at<uint8_t>(y, x) == 0) {
        continue;
      }
      cv::Vec3b& pixel = picture.at<cv::Vec3b>(y, x);
      for (int c = 0; c < 3; ++c) {
        const double light = DecodeSrgb(pixel[c] / 255.0);
        const double albedo =
            DecodeSrgb(unlit.color.at<cv::Vec3b>(y, x)[c] / 255.0);
        pixel[c] = cv::saturate_cast<uint8_t>(255 * EncodeSrgb(light * albedo));
      }
    }
  }
  return picture;
}

}  // namespace octacut
