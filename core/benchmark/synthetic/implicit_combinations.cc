#include <algorithm>
#include <cmath>
#include <limits>

#include "core/benchmark/synthetic/implicit.h"

namespace octacut {
namespace {

// Never more than the distance to the part of a shape within `box`.
double DistanceToBox(const Eigen::AlignedBox3d& box,
                     const Eigen::Vector3d& point) {
  return std::sqrt(box.squaredExteriorDistance(point));
}

}  // namespace

double BlendedMin(double a, double b, double blend) {
  if (blend <= 0) {
    return std::min(a, b);
  }
  const double overlap = std::max(blend - std::abs(a - b), 0.0);
  return std::min(a, b) - overlap * overlap / (4 * blend);
}

ImplicitShape Union(std::vector<ImplicitShape> shapes, double blend) {
  Eigen::AlignedBox3d box;
  double lipschitz = 0;
  double box_slope = 1;
  for (const ImplicitShape& shape : shapes) {
    box.extend(shape.box);
    box_slope = std::min(box_slope, shape.box_slope);
    lipschitz = std::max(lipschitz, shape.lipschitz);
  }
  const Eigen::Vector3d bulge = Eigen::Vector3d::Constant(blend / 4);
  const Eigen::AlignedBox3d grown(box.min() - bulge, box.max() + bulge);
  return {
      [shapes = std::move(shapes), blend](const Eigen::Vector3d& p) {
        double value = std::numeric_limits<double>::infinity();
        for (const ImplicitShape& shape : shapes) {
          // A shape this far away changes nothing.
          if (shape.box_slope * DistanceToBox(shape.box, p) < value + blend) {
            value = BlendedMin(value, shape(p), blend);
          }
        }
        return value;
      },
      grown,
      lipschitz,
      box_slope};
}

ImplicitShape Intersect(ImplicitShape a, ImplicitShape b, double blend) {
  const Eigen::AlignedBox3d box = a.box.intersection(b.box);
  const double lipschitz = std::max(a.lipschitz, b.lipschitz);
  // Beyond a corner of both boxes neither value is the distance to it.
  const double box_slope = std::min(a.box_slope, b.box_slope) / std::sqrt(3.0);
  return {
      [a = std::move(a), b = std::move(b), blend](const Eigen::Vector3d& p) {
        return -BlendedMin(-a(p), -b(p), blend);
      },
      box,
      lipschitz,
      box_slope};
}

ImplicitShape Subtract(ImplicitShape a, ImplicitShape b, double blend) {
  const Eigen::AlignedBox3d box = a.box;
  const double lipschitz = std::max(a.lipschitz, b.lipschitz);
  const double box_slope = a.box_slope;
  return {
      [a = std::move(a), b = std::move(b), blend](const Eigen::Vector3d& p) {
        return -BlendedMin(-a(p), b(p), blend);
      },
      box,
      lipschitz,
      box_slope};
}

ImplicitShape Move(ImplicitShape shape, const Eigen::Vector3d& offset) {
  const Eigen::AlignedBox3d box(shape.box.min() + offset,
                                shape.box.max() + offset);
  const double lipschitz = shape.lipschitz;
  const double box_slope = shape.box_slope;
  return {[shape = std::move(shape), offset](const Eigen::Vector3d& p) {
            return shape(p - offset);
          },
          box,
          lipschitz,
          box_slope};
}

ImplicitShape Rotate(ImplicitShape shape, const Eigen::Matrix3d& rotation) {
  const Eigen::Vector3d center = rotation * shape.box.center();
  const Eigen::Vector3d half = rotation.cwiseAbs() * (shape.box.sizes() / 2);
  const double lipschitz = shape.lipschitz;
  const double box_slope = shape.box_slope;
  return {[shape = std::move(shape), rotation](const Eigen::Vector3d& p) {
            return shape(rotation.transpose() * p);
          },
          {center - half, center + half},
          lipschitz,
          box_slope};
}

ImplicitShape Stretch(ImplicitShape shape, const Eigen::Vector3d& factors) {
  const Eigen::AlignedBox3d box(shape.box.min().cwiseProduct(factors),
                                shape.box.max().cwiseProduct(factors));
  const double smallest = factors.minCoeff();
  const double lipschitz = shape.lipschitz;
  const double box_slope = shape.box_slope * smallest / factors.maxCoeff();
  return {
      [shape = std::move(shape), factors, smallest](const Eigen::Vector3d& p) {
        return smallest * shape(p.cwiseQuotient(factors));
      },
      box,
      lipschitz,
      box_slope};
}

ImplicitShape Displace(ImplicitShape shape,
                       std::function<double(const Eigen::Vector3d&)> height,
                       double bound,
                       double slope) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(bound);
  const Eigen::AlignedBox3d box(shape.box.min() - margin,
                                shape.box.max() + margin);
  const double lipschitz = shape.lipschitz + slope;
  const double box_slope = shape.box_slope;
  return {[shape = std::move(shape), height = std::move(height), bound](
              const Eigen::Vector3d& p) {
            const double value = shape(p);
            // Further out the height fades to nothing, within four times its
            // bound; the surface lies nearer.
            const double fade =
                std::clamp(2 - std::abs(value) / (2 * bound), 0.0, 1.0);
            return fade > 0 ? value - fade * height(p) : value;
          },
          box,
          // The fade's own slope is 1 / (2 bound), the height at most bound.
          lipschitz * 1.5,
          box_slope};
}

}  // namespace octacut
