#include "core/raycast/ray_scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <new>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/bounding_box.h"
#include "core/raycast/triangle.h"

namespace octacut {
namespace {

// Bounds the error of a coordinate of size <= 1 after rounding to float, and
// of Embree's arithmetic on it.
constexpr double kFloatSlack = 1e-6;
// Normalized; the mesh lies within 1.
constexpr float kFar = 1e15f;

[[noreturn]] void ThrowEmbreeError(RTCError error) {
  if (error == RTC_ERROR_OUT_OF_MEMORY) {
    throw std::bad_alloc();
  }
  throw Error(fmt::format("Embree: error {}", static_cast<int>(error)));
}

void ThrowUnlessUsable(const IndexedMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw InputError("mesh for ray casting: no triangles");
  }
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t corner : triangle) {
      if (corner >= mesh.positions.size()) {
        throw InputError(
            fmt::format("mesh for ray casting: corner index {} of {} vertices",
                        corner,
                        mesh.positions.size()));
      }
    }
  }
  for (const Eigen::Vector3d& position : mesh.positions) {
    if (!position.allFinite()) {
      throw InputError("mesh for ray casting: a coordinate is not finite");
    }
  }
}

}  // namespace

struct RayScene::Impl {
  std::vector<Eigen::Vector3d> positions;
  std::vector<std::array<uint32_t, 3>> triangles;
  // normalized = (world - center) / scale lies in [-1, 1]^3.
  Eigen::Vector3d center;
  double scale;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  explicit Impl(const IndexedMesh& mesh)
      : positions(mesh.positions), triangles(mesh.triangles) {
    // Vertices of no triangle do not count.
    const Eigen::AlignedBox3d box = BoxOfTriangles(mesh);
    center = box.center();
    scale = std::max(box.sizes().maxCoeff() / 2,
                     std::numeric_limits<double>::min());
    device = rtcNewDevice(nullptr);
    if (device == nullptr) {
      ThrowEmbreeError(rtcGetDeviceError(nullptr));
    }
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    AttachGeometry();
    rtcCommitScene(scene);
    const RTCError error = rtcGetDeviceError(device);
    if (error != RTC_ERROR_NONE) {
      Release();
      ThrowEmbreeError(error);
    }
  }
  ~Impl() { Release(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void Release() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }

  void AttachGeometry() {
    const RTCGeometry geometry =
        rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices =
        static_cast<float*>(rtcSetNewGeometryBuffer(geometry,
                                                    RTC_BUFFER_TYPE_VERTEX,
                                                    0,
                                                    RTC_FORMAT_FLOAT3,
                                                    3 * sizeof(float),
                                                    positions.size()));
    auto* corners =
        static_cast<uint32_t*>(rtcSetNewGeometryBuffer(geometry,
                                                       RTC_BUFFER_TYPE_INDEX,
                                                       0,
                                                       RTC_FORMAT_UINT3,
                                                       3 * sizeof(uint32_t),
                                                       triangles.size()));
    if (vertices != nullptr && corners != nullptr) {
      for (size_t i = 0; i < positions.size(); ++i) {
        const Eigen::Vector3f vertex = Normalize(positions[i]).cast<float>();
        std::copy_n(vertex.data(), 3, vertices + 3 * i);
      }
      for (size_t i = 0; i < triangles.size(); ++i) {
        std::copy_n(triangles[i].data(), 3, corners + 3 * i);
      }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }

  Eigen::Vector3d Normalize(const Eigen::Vector3d& point) const {
    return (point - center) / scale;
  }

  // A ray in normalized coordinates. `distance = offset + per_unit * tfar`:
  // far origins are moved up to the mesh, where floats are dense.
  struct LocalRay {
    RTCRay ray;
    double offset;
    double per_unit;
    // False far from the mesh, where Embree's arithmetic overflows.
    bool is_near;
  };

  LocalRay MakeRay(const Eigen::Vector3d& origin,
                   const Eigen::Vector3d& direction,
                   double min_distance,
                   double max_distance) const {
    const double length = direction.norm();
    const Eigen::Vector3d unit = direction / length;
    const Eigen::Vector3d start = Normalize(origin);
    LocalRay local;
    local.per_unit = scale / length;
    // The mesh lies within sqrt(3) of the centre.
    const double skip =
        std::max(min_distance / local.per_unit, -start.dot(unit) - 2.0);
    local.offset = skip * local.per_unit;
    const Eigen::Vector3f from = (start + skip * unit).cast<float>();
    local.is_near = from.cwiseAbs().maxCoeff() < kFar;
    const Eigen::Vector3f toward = unit.cast<float>();
    RTCRay& ray = local.ray;
    ray.org_x = from.x();
    ray.org_y = from.y();
    ray.org_z = from.z();
    ray.dir_x = toward.x();
    ray.dir_y = toward.y();
    ray.dir_z = toward.z();
    ray.tnear = 0;
    ray.tfar =
        static_cast<float>((max_distance - local.offset) / local.per_unit);
    ray.time = 0;
    ray.mask = 0xffffffffu;
    ray.id = 0;
    ray.flags = 0;
    return local;
  }

  Hit RefineHit(const Eigen::Vector3d& origin,
                const Eigen::Vector3d& direction,
                const LocalRay& local,
                const RTCHit& coarse) const;
};

// Moeller and Trumbore's intersection, in double precision; where the ray
// grazes the triangle's plane, Embree's own figures stay.
RayScene::Hit RayScene::Impl::RefineHit(const Eigen::Vector3d& origin,
                                        const Eigen::Vector3d& direction,
                                        const LocalRay& local,
                                        const RTCHit& coarse) const {
  Hit hit{local.offset + local.per_unit * local.ray.tfar,
          coarse.primID,
          {coarse.u, coarse.v}};
  const auto& corners = triangles[coarse.primID];
  const Eigen::Vector3d ab = positions[corners[1]] - positions[corners[0]];
  const Eigen::Vector3d ac = positions[corners[2]] - positions[corners[0]];
  const Eigen::Vector3d from_a = origin - positions[corners[0]];
  const Eigen::Vector3d across = direction.cross(ac);
  const double determinant = ab.dot(across);
  if (determinant != 0) {
    const Eigen::Vector3d side = from_a.cross(ab);
    const double distance = ac.dot(side) / determinant;
    if (std::abs(distance - hit.distance) <=
        100 * kFloatSlack * local.per_unit) {
      hit.distance = distance;
      const double u = from_a.dot(across) / determinant;
      const double v = direction.dot(side) / determinant;
      hit.barycentric = {static_cast<float>(std::clamp(u, 0.0, 1.0)),
                         static_cast<float>(std::clamp(v, 0.0, 1.0))};
    }
  }
  return hit;
}

RayScene::RayScene(const IndexedMesh& mesh) {
  ThrowUnlessUsable(mesh);
  impl_ = std::make_unique<Impl>(mesh);
}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

std::optional<RayScene::Hit> RayScene::FirstHit(
    const Eigen::Vector3d& origin,
    const Eigen::Vector3d& direction,
    double min_distance) const {
  Impl::LocalRay local = impl_->MakeRay(
      origin, direction, min_distance, std::numeric_limits<double>::infinity());
  if (!local.is_near) {
    return std::nullopt;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query;
  query.ray = local.ray;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.primID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
    return std::nullopt;
  }
  local.ray.tfar = query.ray.tfar;
  return impl_->RefineHit(origin, direction, local, query.hit);
}

bool RayScene::IsOccluded(const Eigen::Vector3d& origin,
                          const Eigen::Vector3d& direction,
                          double min_distance,
                          double max_distance) const {
  Impl::LocalRay local =
      impl_->MakeRay(origin, direction, min_distance, max_distance);
  if (!(local.ray.tfar >= 0) || !local.is_near) {
    return false;  // ends before the mesh begins, or passes far from it
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(impl_->scene, &context, &local.ray);
  return local.ray.tfar < 0;  // Embree's mark of a hit
}

namespace {

struct PointQuery {
  const std::vector<Eigen::Vector3d>& positions;
  const std::vector<std::array<uint32_t, 3>>& triangles;
  Eigen::Vector3d query;
  double scale;
  double slack;  // normalized
  RayScene::Closest best;

  // Never less than the true one, so that rounding hides no triangle.
  float Radius() const {
    return static_cast<float>(best.distance / scale + slack);
  }
  bool Offer(uint32_t triangle);  // whether it is better
};

bool PointQuery::Offer(uint32_t triangle) {
  const auto& corners = triangles[triangle];
  const Eigen::Vector3d& a = positions[corners[0]];
  const Eigen::Vector3d& b = positions[corners[1]];
  const Eigen::Vector3d& c = positions[corners[2]];
  // Most triangles that Embree offers lie in a box that is too far away.
  const Eigen::Vector3d below = a.cwiseMin(b).cwiseMin(c) - query;
  const Eigen::Vector3d above = query - a.cwiseMax(b).cwiseMax(c);
  if (below.cwiseMax(above).cwiseMax(0).squaredNorm() >
      (1 + 1e-12) * best.distance * best.distance) {
    return false;
  }
  const Eigen::Vector3d point = ClosestPointOnTriangle(query, a, b, c);
  const double distance = (point - query).norm();
  if (distance > best.distance ||
      (distance == best.distance && triangle >= best.triangle)) {
    return false;
  }
  best = {point, distance, triangle};
  return true;
}

bool VisitTriangle(RTCPointQueryFunctionArguments* arguments) {
  PointQuery& state = *static_cast<PointQuery*>(arguments->userPtr);
  if (!state.Offer(arguments->primID)) {
    return false;
  }
  arguments->query->radius = state.Radius();
  return true;
}

}  // namespace

RayScene::Closest RayScene::ClosestPoint(const Eigen::Vector3d& query,
                                         std::optional<uint32_t> near) const {
  const Eigen::Vector3d normalized = impl_->Normalize(query);
  PointQuery state{impl_->positions,
                   impl_->triangles,
                   query,
                   impl_->scale,
                   kFloatSlack * (1 + normalized.lpNorm<1>()),
                   {query,
                    std::numeric_limits<double>::infinity(),
                    std::numeric_limits<uint32_t>::max()}};
  RTCPointQuery point_query;
  point_query.radius = std::numeric_limits<float>::infinity();
  if (near) {
    state.Offer(*near);
    point_query.radius = state.Radius();
  }
  point_query.x = static_cast<float>(normalized.x());
  point_query.y = static_cast<float>(normalized.y());
  point_query.z = static_cast<float>(normalized.z());
  point_query.time = 0;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(impl_->scene, &point_query, &context, &VisitTriangle, &state);
  return state.best;
}

}  // namespace octacut
