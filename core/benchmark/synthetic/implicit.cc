#include "core/benchmark/synthetic/implicit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace octacut {

Eigen::Vector3d ImplicitGradient(const ImplicitShape& shape,
                                 const Eigen::Vector3d& point,
                                 double step) {
  // Four corners of a tetrahedron around the point.
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& corner : {Eigen::Vector3d(1, -1, -1),
                                        Eigen::Vector3d(-1, -1, 1),
                                        Eigen::Vector3d(-1, 1, -1),
                                        Eigen::Vector3d(1, 1, 1)}) {
    gradient += shape(point + step * corner) * corner;
  }
  return gradient / (4 * step);
}

ImplicitShape MakeSphere(double radius) {
  const Eigen::Vector3d corner = Eigen::Vector3d::Constant(radius);
  return {[radius](const Eigen::Vector3d& p) { return p.norm() - radius; },
          {-corner, corner}};
}

ImplicitShape MakeTorus(double major_radius, double minor_radius) {
  const double outer = major_radius + minor_radius;
  const Eigen::Vector3d corner(outer, outer, minor_radius);
  return {[=](const Eigen::Vector3d& p) {
            return std::hypot(std::hypot(p.x(), p.y()) - major_radius, p.z()) -
                   minor_radius;
          },
          {-corner, corner}};
}

ImplicitShape MakeBox(const Eigen::Vector3d& half_edges, double rounding) {
  const Eigen::Vector3d core = half_edges - Eigen::Vector3d::Constant(rounding);
  return {[=](const Eigen::Vector3d& p) {
            const Eigen::Vector3d beyond = p.cwiseAbs() - core;
            return beyond.cwiseMax(0).norm() +
                   std::min(beyond.maxCoeff(), 0.0) - rounding;
          },
          {-half_edges, half_edges}};
}

ImplicitShape MakeCylinder(double radius, double half_height, double rounding) {
  const Eigen::Vector3d corner(radius, radius, half_height);
  return {[=](const Eigen::Vector3d& p) {
            const double side = std::hypot(p.x(), p.y()) - radius + rounding;
            const double top = std::abs(p.z()) - half_height + rounding;
            return std::hypot(std::max(side, 0.0), std::max(top, 0.0)) +
                   std::min(std::max(side, top), 0.0) - rounding;
          },
          {-corner, corner}};
}

ImplicitShape MakeBar(const Eigen::Vector3d& begin,
                      const Eigen::Vector3d& end,
                      double begin_radius,
                      double end_radius) {
  Eigen::AlignedBox3d box;
  box.extend(begin - Eigen::Vector3d::Constant(begin_radius));
  box.extend(begin + Eigen::Vector3d::Constant(begin_radius));
  box.extend(end - Eigen::Vector3d::Constant(end_radius));
  box.extend(end + Eigen::Vector3d::Constant(end_radius));
  const Eigen::Vector3d along = end - begin;
  const double length = along.norm();
  const Eigen::Vector3d scaled = along / (length * length);
  const double growth = end_radius - begin_radius;
  return {[=](const Eigen::Vector3d& p) {
            const double t = std::clamp(scaled.dot(p - begin), 0.0, 1.0);
            return (p - begin - t * along).norm() - begin_radius - t * growth;
          },
          box,
          1 + std::abs(growth) / length};
}

namespace {

Eigen::Vector4d CatmullRom(const Eigen::Vector4d& before,
                           const Eigen::Vector4d& begin,
                           const Eigen::Vector4d& end,
                           const Eigen::Vector4d& after,
                           double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return 0.5 * (2 * begin + (end - before) * t +
                (2 * before - 5 * begin + 4 * end - after) * t2 +
                (3 * begin - before - 3 * end + after) * t3);
}

// One straight piece of a tube.
struct TubePiece {
  TubePiece(const Eigen::Vector4d& from, const Eigen::Vector4d& to)
      : begin(from.head<3>()),
        along(to.head<3>() - begin),
        scaled(along / along.squaredNorm()),
        radius(from.w()),
        growth(to.w() - radius),
        middle(begin + along / 2),
        reach(along.norm() / 2 + std::max(from.w(), to.w())) {}

  Eigen::Vector3d begin, along, scaled;
  double radius, growth;
  Eigen::Vector3d middle;  // the piece is within `reach` of it
  double reach;
};

double TubeValue(const std::vector<TubePiece>& pieces,
                 const Eigen::Vector3d& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const TubePiece& piece : pieces) {
    const double limit = best + piece.reach;
    if (limit > 0 && (p - piece.middle).squaredNorm() > limit * limit) {
      continue;  // no nearer than what is found already
    }
    const double t = std::clamp(piece.scaled.dot(p - piece.begin), 0.0, 1.0);
    best = std::min(best,
                    (p - piece.begin - t * piece.along).norm() - piece.radius -
                        t * piece.growth);
  }
  return best;
}

std::vector<Eigen::Vector4d> SampleSpline(
    const std::vector<Eigen::Vector4d>& points, int steps) {
  std::vector<Eigen::Vector4d> curve{points.front()};
  const int last = static_cast<int>(points.size()) - 1;
  for (int i = 0; i < last; ++i) {
    for (int k = 1; k <= steps; ++k) {
      curve.push_back(CatmullRom(points[std::max(i - 1, 0)],
                                 points[i],
                                 points[i + 1],
                                 points[std::min(i + 2, last)],
                                 static_cast<double>(k) / steps));
    }
  }
  return curve;
}

}  // namespace

ImplicitShape MakeTube(const std::vector<Eigen::Vector4d>& points, int steps) {
  const std::vector<Eigen::Vector4d> curve = SampleSpline(points, steps);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector4d& point : curve) {
    const Eigen::Vector3d corner = Eigen::Vector3d::Constant(point.w());
    box.extend(point.head<3>() - corner);
    box.extend(point.head<3>() + corner);
  }
  std::vector<TubePiece> pieces;
  double lipschitz = 1;
  for (size_t i = 1; i < curve.size(); ++i) {
    pieces.emplace_back(curve[i - 1], curve[i]);
    const TubePiece& piece = pieces.back();
    lipschitz =
        std::max(lipschitz, 1 + std::abs(piece.growth) / piece.along.norm());
  }
  return {[pieces = std::move(pieces)](const Eigen::Vector3d& p) {
            return TubeValue(pieces, p);
          },
          box,
          lipschitz};
}

}  // namespace octacut
