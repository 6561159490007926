#include "core/texture/bake_normals.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <opencv2/core.hpp>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/bounding_box.h"
#include "core/mesh/normals.h"
#include "core/texture/fill_gaps.h"
#include "core/texture/pixel_sampler.h"
#include "core/texture/triangle_raster.h"

namespace octacut {
namespace {

constexpr size_t kFacesPerChunk = 512;
// Part of the diagonal: some times what a mesh is off that was reduced to a
// hundredth of its triangles, and less than most walls are thick.
constexpr double kMaxDistance = 0.01;
// Part of the diagonal by which rays begin behind the surface, so that they do
// not miss a point that both meshes share: ten roundings of Embree's floats.
constexpr double kStepBack = 1e-6;
// Rays per texel along a side, since the full mesh may have more detail than
// there are texels.
constexpr int kSamplesASide = 2;
// Least z that is stored: surfaces that face away cannot be mapped.
constexpr float kLeastZ = 0.02f;

Eigen::Vector3f UnitOr(const Eigen::Vector3f& vector,
                       const Eigen::Vector3f& otherwise) {
  const float norm = vector.norm();
  return std::isfinite(norm) && norm > 1e-12f ? Eigen::Vector3f(vector / norm)
                                              : otherwise;
}

Eigen::Vector3f UnitNormal(const TexturedMesh& mesh, uint32_t vertex) {
  return UnitOr(mesh.mesh.normals[vertex], Eigen::Vector3f::UnitZ());
}

// Area on the page with y up, twice; negative where it shows the triangle from
// behind.
double PageArea(const std::array<Eigen::Vector2d, 3>& texels) {
  const Eigen::Vector2d b = texels[1] - texels[0];
  const Eigen::Vector2d c = texels[2] - texels[0];
  return b.y() * c.x() - b.x() * c.y();
}

// The derivative of the position with respect to x on the page; zero for
// triangles that are lines there.
Eigen::Vector3f FaceTangent(const IndexedMesh& mesh,
                            size_t face,
                            const std::array<Eigen::Vector2d, 3>& texels) {
  const auto& corners = mesh.triangles[face];
  const Eigen::Vector3d& a = mesh.positions[corners[0]];
  const Eigen::Vector2d b = texels[1] - texels[0];
  const Eigen::Vector2d c = texels[2] - texels[0];
  const double area = b.x() * c.y() - b.y() * c.x();
  const Eigen::Vector3d tangent = (c.y() * (mesh.positions[corners[1]] - a) -
                                   b.y() * (mesh.positions[corners[2]] - a)) /
                                  area;
  return tangent.allFinite() ? UnitOr(tangent.cast<float>(), {0, 0, 0})
                             : Eigen::Vector3f::Zero();
}

// One tangent for each vertex and chart: the mean of the tangents of triangles,
// weighted by their areas on the page.
void AddTangents(const AtlasLayout& layout, TexturedMesh* textured) {
  const IndexedMesh& mesh = textured->mesh;
  std::unordered_map<uint64_t, Eigen::Vector3f> sums;
  std::vector<double> areas(layout.charts.charts.size(), 0);
  const auto key = [&](size_t f, size_t k) {
    return uint64_t{textured->charts[f]} << 32 | mesh.triangles[f][k];
  };
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto texels = layout.TexelsOf(f);
    const double area = PageArea(texels);
    areas[textured->charts[f]] += area;
    const Eigen::Vector3f tangent =
        float(std::abs(area)) * FaceTangent(mesh, f, texels);
    for (size_t k = 0; k < 3; ++k) {
      sums.try_emplace(key(f, k), Eigen::Vector3f::Zero()).first->second +=
          tangent;
    }
  }
  textured->tangents.resize(mesh.triangles.size());
  for (size_t f = 0; f < mesh.triangles.size(); ++f) {
    const float sign = areas[textured->charts[f]] < 0 ? -1.0f : 1.0f;
    for (size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3f normal =
          UnitNormal(*textured, mesh.triangles[f][k]);
      const Eigen::Vector3f sum = UnitOr(sums.at(key(f, k)), {0, 0, 0});
      const Eigen::Vector3f flat = sum - normal * normal.dot(sum);
      const Eigen::Vector3f tangent =
          flat.norm() > 1e-3f ? flat.normalized() : normal.unitOrthogonal();
      textured->tangents[f][k].head<3>() = tangent;
      textured->tangents[f][k].w() = sign;
    }
  }
}

// Columns: tangent, bitangent and normal at a point of a triangle.
Eigen::Matrix3f FrameAt(const TexturedMesh& mesh,
                        size_t face,
                        const Eigen::Vector3f& weights) {
  Eigen::Matrix3f frame = Eigen::Matrix3f::Zero();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3f normal =
        UnitNormal(mesh, mesh.mesh.triangles[face][size_t(k)]);
    const Eigen::Vector4f& tangent = mesh.tangents[face][size_t(k)];
    frame.col(0) += weights[k] * tangent.head<3>();
    frame.col(1) += weights[k] * tangent[3] * normal.cross(tangent.head<3>());
    frame.col(2) += weights[k] * normal;
  }
  return frame.colwise().normalized();
}

// The full mesh as rays find it.
class FullSurface {
 public:
  FullSurface(const IndexedMesh& mesh, const Context& context)
      : mesh_(mesh), rays_(mesh) {
    if (mesh.normals.empty()) {
      own_normals_ = ComputeVertexNormals(mesh, context);
    }
    const double size = BoxOfTriangles(mesh).diagonal().norm();
    max_distance_ = kMaxDistance * size;
    step_back_ = kStepBack * size;
  }

  double MaxDistance() const { return max_distance_; }

  // The normal of the nearest point along `normal` (a unit vector) on either
  // side of `point`; zero where there is none.
  Eigen::Vector3f NormalNear(const Eigen::Vector3d& point,
                             const Eigen::Vector3d& normal) const {
    Eigen::Vector3f found = Eigen::Vector3f::Zero();
    double nearest = max_distance_ + step_back_;
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d direction = side * normal;
      const auto hit =
          rays_.FirstHit(point - step_back_ * direction, direction);
      if (hit && hit->distance < nearest) {
        const Eigen::Vector3f there = NormalAt(*hit);
        if (there.dot(normal.cast<float>()) > 0) {
          nearest = hit->distance;
          found = there;
        }
      }
    }
    return found;
  }

 private:
  Eigen::Vector3f NormalAt(const RayScene::Hit& hit) const {
    const auto& normals = mesh_.normals.empty() ? own_normals_ : mesh_.normals;
    const auto& corners = mesh_.triangles[hit.triangle];
    return UnitOr(
        hit.Mix(normals[corners[0]], normals[corners[1]], normals[corners[2]]),
        {0, 0, 0});
  }

  const IndexedMesh& mesh_;
  const RayScene rays_;
  std::vector<Eigen::Vector3f> own_normals_;
  double max_distance_ = 0;
  double step_back_ = 0;
};

struct TexelCounts {
  size_t num_texels = 0;
  size_t num_missed = 0;
  double angles = 0;  // sum, of the texels that are not missed, radians
};

class PageBaker {
 public:
  PageBaker(const FullSurface& full,
            const AtlasLayout& layout,
            const TexturedMesh& mesh,
            cv::Mat map)
      : full_(full),
        layout_(layout),
        mesh_(mesh),
        map_(std::move(map)),
        normals_(map_.size(), CV_8UC3, cv::Scalar(255, 128, 128)) {}

  void BakeFace(size_t f, TexelCounts* counts) {
    const auto texels = layout_.TexelsOf(f);
    ForTexelsOf(map_, f, texels, [&](int x, int y) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int j = 0; j < kSamplesASide; ++j) {
        for (int i = 0; i < kSamplesASide; ++i) {
          sum += MappedSample(
              f,
              texels,
              {x + (i + 0.5) / kSamplesASide, y + (j + 0.5) / kSamplesASide});
        }
      }
      const bool is_missed = sum.isZero();
      const Eigen::Vector3f mapped = UnitOr(sum, Eigen::Vector3f::UnitZ());
      Store(mapped, &normals_.at<cv::Vec3b>(y, x));
      if (map_.at<int>(y, x) > 0) {
        ++counts->num_texels;
        counts->num_missed += is_missed;
        counts->angles += is_missed ? 0 : std::acos(std::min(1.0f, mapped.z()));
      }
    });
  }

  cv::Mat Finish() {
    FillGaps(map_ != 0, &normals_);
    return normals_;
  }

 private:
  // In the frame of the surface there; zero where no point is near enough.
  Eigen::Vector3f MappedSample(size_t f,
                               const std::array<Eigen::Vector2d, 3>& texels,
                               const Eigen::Vector2d& texel) const {
    Eigen::Vector3d weights = BoundedCornerWeights(texels, texel);
    // Outside of the triangle the nearest point within, since the surface bends
    // away from the plane.
    weights = weights.cwiseMax(0);
    weights /= weights.sum();
    const auto& corners = mesh_.mesh.triangles[f];
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      point += weights[k] * mesh_.mesh.positions[corners[size_t(k)]];
    }
    const Eigen::Matrix3f frame = FrameAt(mesh_, f, weights.cast<float>());
    const Eigen::Vector3f normal =
        full_.NormalNear(point, frame.col(2).cast<double>().normalized());
    if (normal.isZero()) {
      return Eigen::Vector3f::Zero();
    }
    Eigen::Vector3f mapped = frame.inverse() * normal;
    if (!mapped.allFinite()) {
      return Eigen::Vector3f::Zero();
    }
    mapped.z() = std::max(mapped.z(), kLeastZ);
    return mapped.normalized();
  }

  static void Store(const Eigen::Vector3f& mapped, cv::Vec3b* pixel) {
    for (int c = 0; c < 3; ++c) {
      (*pixel)[2 - c] = cv::saturate_cast<uint8_t>(127.5f * (mapped[c] + 1));
    }
  }

  const FullSurface& full_;
  const AtlasLayout& layout_;
  const TexturedMesh& mesh_;
  const cv::Mat map_;
  cv::Mat normals_;
};

}  // namespace

NormalMapSummary BakeNormals(const IndexedMesh& full,
                             const AtlasLayout& layout,
                             const Context& context,
                             TexturedMesh* textured) {
  if (full.triangles.empty()) {
    throw InputError("the mesh for the normal map has no triangles");
  }
  AddTangents(layout, textured);
  const FullSurface surface(full, context);
  const size_t num_faces = textured->mesh.triangles.size();
  NormalMapSummary summary;
  summary.max_distance = surface.MaxDistance();
  TexelCounts total;
  Phase phase(context, "normal map", num_faces);
  for (uint32_t page = 0; page < textured->pages.size(); ++page) {
    PageBaker baker(
        surface, layout, *textured, MapTexels(layout, page, context));
    // Sums of each chunk, so that they do not depend on the threads.
    std::vector<TexelCounts> counts(NumChunks(num_faces, kFacesPerChunk));
    ParallelChunks(context,
                   num_faces,
                   kFacesPerChunk,
                   [&](size_t chunk, size_t begin, size_t end) {
                     size_t num_baked = 0;
                     for (size_t f = begin; f < end; ++f) {
                       if (textured->PageOf(f) == page) {
                         baker.BakeFace(f, &counts[chunk]);
                         ++num_baked;
                       }
                     }
                     phase.Advance(num_baked);
                   });
    for (const TexelCounts& count : counts) {
      total.num_texels += count.num_texels;
      total.num_missed += count.num_missed;
      total.angles += count.angles;
    }
    textured->pages[page].normals = baker.Finish();
  }
  summary.num_texels = total.num_texels;
  summary.num_missed = total.num_missed;
  if (2 * total.num_missed > total.num_texels) {
    throw InputError(fmt::format(
        "the mesh for the normal map is further than {:.4g} (1 % of its "
        "diagonal) from {:.0f} % of the textured mesh; are both in the same "
        "frame?",
        summary.max_distance,
        100 * double(total.num_missed) / double(total.num_texels)));
  }
  // A map may be so small that no texel lies in a triangle.
  const size_t num_baked =
      std::max<size_t>(1, total.num_texels - total.num_missed);
  summary.mean_angle =
      total.angles / double(num_baked) * 180 / std::numbers::pi;
  return summary;
}

Eigen::Vector3f MappedNormal(const TexturedMesh& mesh,
                             const RayScene::Hit& hit) {
  const Eigen::Vector3f weights(
      1 - hit.barycentric.sum(), hit.barycentric.x(), hit.barycentric.y());
  Eigen::Vector2f uv = Eigen::Vector2f::Zero();
  for (int k = 0; k < 3; ++k) {
    uv += weights[k] * mesh.texcoords[hit.triangle][size_t(k)];
  }
  const cv::Mat& page = mesh.pages[mesh.PageOf(hit.triangle)].normals;
  const Eigen::Vector3f stored =
      SamplePixels(page, double(uv.x()) * page.cols, double(uv.y()) * page.rows)
          .reverse();
  return (FrameAt(mesh, hit.triangle, weights) *
          (stored / 127.5f - Eigen::Vector3f::Ones()))
      .normalized();
}

}  // namespace octacut
