// Solids given by an implicit function, and how to combine them.
//
// The primitives are signed distances; the combinations keep a bound on the
// slope instead: |value(p) - value(q)| <= lipschitz * |p - q|.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <utility>
#include <vector>

namespace octacut {

struct ImplicitShape {
  // Negative inside, positive outside, zero on the surface. May be called
  // from any thread.
  std::function<double(const Eigen::Vector3d&)> value;
  Eigen::AlignedBox3d box;  // the surface is inside
  double lipschitz = 1;
  // Outside the box: value(p) >= box_slope * distance(p, box).
  double box_slope = 1;

  double operator()(const Eigen::Vector3d& point) const { return value(point); }
};

// Gradient of the value by differences over `step`: points outward, of about
// unit length where the value is a distance.
Eigen::Vector3d ImplicitGradient(const ImplicitShape& shape,
                                 const Eigen::Vector3d& point,
                                 double step);

// Primitives around the origin; cylinder and torus about the z axis. Edges
// are rounded with the given radius, which adds nothing to the size.
ImplicitShape MakeSphere(double radius);
ImplicitShape MakeTorus(double major_radius, double minor_radius);
ImplicitShape MakeBox(const Eigen::Vector3d& half_edges, double rounding);
ImplicitShape MakeCylinder(double radius, double half_height, double rounding);
// A round bar with round ends whose radius goes from one to the other.
ImplicitShape MakeBar(const Eigen::Vector3d& begin,
                      const Eigen::Vector3d& end,
                      double begin_radius,
                      double end_radius);
// A bent bar along a Catmull-Rom spline through at least two points
// (x, y, z, radius); the curve is followed in `steps` straight pieces between
// two points.
ImplicitShape MakeTube(const std::vector<Eigen::Vector4d>& points,
                       int steps = 8);

// Smooth minimum with quadratic transition over `blend`: its slope does not
// exceed that of the steeper operand.
double BlendedMin(double a, double b, double blend);

// Combinations. `blend` is the size of the rounded transition (0: none).
ImplicitShape Union(std::vector<ImplicitShape> shapes, double blend = 0);
ImplicitShape Intersect(ImplicitShape a, ImplicitShape b, double blend = 0);
ImplicitShape Subtract(ImplicitShape a, ImplicitShape b, double blend = 0);
ImplicitShape Move(ImplicitShape shape, const Eigen::Vector3d& offset);
ImplicitShape Rotate(ImplicitShape shape, const Eigen::Matrix3d& rotation);
// Stretches along the axes; the value stays a lower bound of the distance.
ImplicitShape Stretch(ImplicitShape shape, const Eigen::Vector3d& factors);
// Moves the surface outward by `height(p)`, which lies in [-bound, bound] and
// whose slope is at most `slope`. Only asked near the surface.
ImplicitShape Displace(ImplicitShape shape,
                       std::function<double(const Eigen::Vector3d&)> height,
                       double bound,
                       double slope);

}  // namespace octacut
