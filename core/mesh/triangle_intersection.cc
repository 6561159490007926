#include "core/mesh/triangle_intersection.h"

#include <Eigen/Geometry>
#include <utility>

#include "core/mesh/exact_predicates.h"

namespace octacut {
namespace {

using Point = Eigen::Vector3d;

bool AreOnOneSide(int a, int b, int c) {
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

// The axis along which the triangle can be seen, the fullest view first.
int AxisToDrop(const TriangleCorners& t) {
  const Point normal = (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs();
  int axis = 0;
  normal.maxCoeff(&axis);
  for (int turn = 0; turn < 3; ++turn) {
    if (Orient2d(t[0], t[1], t[2], axis) != 0) {
      break;
    }
    axis = (axis + 1) % 3;
  }
  return axis;
}

// The three points are collinear in the projection; is p within [a, b]?
bool IsBetween(const Point& p, const Point& a, const Point& b, int drop) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != drop && (p[axis] < std::min(a[axis], b[axis]) ||
                         p[axis] > std::max(a[axis], b[axis]))) {
      return false;
    }
  }
  return true;
}

bool SegmentsMeet(
    const Point& p, const Point& q, const Point& a, const Point& b, int drop) {
  const int side_a = Orient2d(p, q, a, drop);
  const int side_b = Orient2d(p, q, b, drop);
  const int side_p = Orient2d(a, b, p, drop);
  const int side_q = Orient2d(a, b, q, drop);
  if (side_a * side_b < 0 && side_p * side_q < 0) {
    return true;
  }
  return (side_a == 0 && IsBetween(a, p, q, drop)) ||
         (side_b == 0 && IsBetween(b, p, q, drop)) ||
         (side_p == 0 && IsBetween(p, a, b, drop)) ||
         (side_q == 0 && IsBetween(q, a, b, drop));
}

bool IsInside(const Point& p, const TriangleCorners& t, int drop) {
  const int s0 = Orient2d(t[0], t[1], p, drop);
  const int s1 = Orient2d(t[1], t[2], p, drop);
  const int s2 = Orient2d(t[2], t[0], p, drop);
  return !((s0 > 0 || s1 > 0 || s2 > 0) && (s0 < 0 || s1 < 0 || s2 < 0));
}

bool CoplanarSegmentMeets(const Point& p,
                          const Point& q,
                          const TriangleCorners& t) {
  const int drop = AxisToDrop(t);
  return IsInside(p, t, drop) || IsInside(q, t, drop) ||
         SegmentsMeet(p, q, t[0], t[1], drop) ||
         SegmentsMeet(p, q, t[1], t[2], drop) ||
         SegmentsMeet(p, q, t[2], t[0], drop);
}

// Closed segment against closed triangle; the sides of its ends against the
// triangle's plane are known.
bool SegmentMeets(const Point& p,
                  const Point& q,
                  int side_p,
                  int side_q,
                  const TriangleCorners& t) {
  if (side_p * side_q > 0) {
    return false;
  }
  if (side_p == 0 && side_q == 0) {
    return CoplanarSegmentMeets(p, q, t);
  }
  const int s0 = Orient3d(p, q, t[0], t[1]);
  const int s1 = Orient3d(p, q, t[1], t[2]);
  const int s2 = Orient3d(p, q, t[2], t[0]);
  return !((s0 > 0 || s1 > 0 || s2 > 0) && (s0 < 0 || s1 < 0 || s2 < 0));
}

std::array<int, 3> SidesOf(const TriangleCorners& points,
                           const TriangleCorners& plane) {
  return {Orient3d(plane[0], plane[1], plane[2], points[0]),
          Orient3d(plane[0], plane[1], plane[2], points[1]),
          Orient3d(plane[0], plane[1], plane[2], points[2])};
}

bool AnyEdgeMeets(const TriangleCorners& edges,
                  const std::array<int, 3>& sides,
                  const TriangleCorners& triangle) {
  return SegmentMeets(edges[0], edges[1], sides[0], sides[1], triangle) ||
         SegmentMeets(edges[1], edges[2], sides[1], sides[2], triangle) ||
         SegmentMeets(edges[2], edges[0], sides[2], sides[0], triangle);
}

bool SeparateTrianglesMeet(const TriangleCorners& first,
                           const TriangleCorners& second) {
  const std::array<int, 3> sides_second = SidesOf(second, first);
  if (AreOnOneSide(sides_second[0], sides_second[1], sides_second[2])) {
    return false;
  }
  const std::array<int, 3> sides_first = SidesOf(first, second);
  if (AreOnOneSide(sides_first[0], sides_first[1], sides_first[2])) {
    return false;
  }
  return AnyEdgeMeets(second, sides_second, first) ||
         AnyEdgeMeets(first, sides_first, second);
}

// Whether the ray from `apex` through p lies in the closed wedge between the
// rays through a and b, whose angle has the sign `turn`.
bool IsInWedge(const Point& apex,
               const Point& a,
               const Point& b,
               int turn,
               const Point& p,
               int drop) {
  return Orient2d(apex, a, p, drop) * turn >= 0 &&
         Orient2d(apex, p, b, drop) * turn >= 0;
}

// In one plane, with corner 0 shared: wedges meet beyond their apex when a
// side of one lies in the other, and then so do the triangles.
bool WedgesMeet(const TriangleCorners& first, const TriangleCorners& second) {
  const int drop = AxisToDrop(first);
  const Point& apex = first[0];
  const int turn_1 = Orient2d(apex, first[1], first[2], drop);
  const int turn_2 = Orient2d(apex, second[1], second[2], drop);
  return IsInWedge(apex, first[1], first[2], turn_1, second[1], drop) ||
         IsInWedge(apex, first[1], first[2], turn_1, second[2], drop) ||
         IsInWedge(apex, second[1], second[2], turn_2, first[1], drop) ||
         IsInWedge(apex, second[1], second[2], turn_2, first[2], drop);
}

// Corner 0 is shared. A common point elsewhere can be pushed away from it
// until it leaves one of the triangles, through the edge opposite corner 0.
bool TrianglesAtVertexMeet(const TriangleCorners& first,
                           const TriangleCorners& second) {
  const int side_1 = Orient3d(first[0], first[1], first[2], second[1]);
  const int side_2 = Orient3d(first[0], first[1], first[2], second[2]);
  if (side_1 * side_2 > 0) {
    return false;
  }
  if (side_1 == 0 && side_2 == 0) {
    return WedgesMeet(first, second);
  }
  const int other_1 = Orient3d(second[0], second[1], second[2], first[1]);
  const int other_2 = Orient3d(second[0], second[1], second[2], first[2]);
  if (other_1 * other_2 > 0) {
    return false;
  }
  return SegmentMeets(second[1], second[2], side_1, side_2, first) ||
         SegmentMeets(first[1], first[2], other_1, other_2, second);
}

// Corners 0 and 1 are shared: more than the edge only when folded over in one
// plane.
bool TrianglesAtEdgeMeet(const TriangleCorners& first,
                         const TriangleCorners& second) {
  if (Orient3d(first[0], first[1], first[2], second[2]) != 0) {
    return false;
  }
  const int drop = AxisToDrop(first);
  return Orient2d(first[0], first[1], first[2], drop) *
             Orient2d(first[0], first[1], second[2], drop) >
         0;
}

}  // namespace

bool IsDegenerate(const TriangleCorners& t) {
  const Point ab = t[1] - t[0];
  const Point ac = t[2] - t[0];
  const double scale = ab.cwiseAbs().maxCoeff() * ac.cwiseAbs().maxCoeff();
  // Far above the rounding of the products; of the differences only where
  // they are not far smaller than the coordinates.
  const double coordinates = std::max({t[0].cwiseAbs().maxCoeff(),
                                       t[1].cwiseAbs().maxCoeff(),
                                       t[2].cwiseAbs().maxCoeff()});
  const double rounding =
      1e-15 * (scale + coordinates * (ab.cwiseAbs().maxCoeff() +
                                      ac.cwiseAbs().maxCoeff()));
  if (ab.cross(ac).cwiseAbs().maxCoeff() > 8 * rounding) {
    return false;
  }
  return Orient2d(t[0], t[1], t[2], 0) == 0 &&
         Orient2d(t[0], t[1], t[2], 1) == 0 &&
         Orient2d(t[0], t[1], t[2], 2) == 0;
}

bool TrianglesIntersect(const TriangleCorners& first,
                        const TriangleCorners& second) {
  // Shared corners are moved to the front of both.
  TriangleCorners a = first;
  TriangleCorners b = second;
  int num_shared = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = num_shared; j < 3; ++j) {
      if (a[i] == b[j]) {
        std::swap(a[i], a[num_shared]);
        std::swap(b[j], b[num_shared]);
        ++num_shared;
        break;
      }
    }
  }
  switch (num_shared) {
    case 0:
      return SeparateTrianglesMeet(a, b);
    case 1:
      return TrianglesAtVertexMeet(a, b);
    case 2:
      return TrianglesAtEdgeMeet(a, b);
    default:
      return true;
  }
}

}  // namespace octacut
