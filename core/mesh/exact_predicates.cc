#include "core/mesh/exact_predicates.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace octacut {
namespace {

constexpr double kEpsilon = 0x1p-53;
// Shewchuk's ccwerrboundA and o3derrboundA.
constexpr double kBound2d = (3 + 16 * kEpsilon) * kEpsilon;
constexpr double kBound3d = (7 + 56 * kEpsilon) * kEpsilon;

// sum + error == a + b (Knuth).
inline void TwoSum(double a, double b, double* sum, double* error) {
  *sum = a + b;
  const double virtual_b = *sum - a;
  const double virtual_a = *sum - virtual_b;
  *error = (a - virtual_a) + (b - virtual_b);
}

// The two halves of a double, of 26 bits each (Veltkamp).
inline void Split(double a, double* high, double* low) {
  const double c = 0x1p27 * a + a;
  *high = c - (c - a);
  *low = a - *high;
}

// product + error == a * b (Dekker).
inline void TwoProduct(double a, double b, double* product, double* error) {
  *product = a * b;
  double a_high, a_low, b_high, b_low;
  Split(a, &a_high, &a_low);
  Split(b, &b_high, &b_low);
  const double rest =
      ((*product - a_high * b_high) - a_low * b_high) - a_high * b_low;
  *error = a_low * b_low - rest;
}

// An exact sum. Components do not overlap and grow in magnitude; zeros are
// dropped, so the last one has the sign of the sum.
class Expansion {
 public:
  // Shewchuk's GROW-EXPANSION.
  void Add(double value) {
    size_t kept = 0;
    for (size_t i = 0; i < size_; ++i) {
      double error;
      TwoSum(value, parts_[i], &value, &error);
      if (error != 0) {
        parts_[kept++] = error;
      }
    }
    if (value != 0) {
      parts_[kept++] = value;
    }
    size_ = kept;
  }

  void AddProduct(double a, double b) {
    double product, error;
    TwoProduct(a, b, &product, &error);
    Add(error);
    Add(product);
  }

  void AddProduct(double a, double b, double c) {
    double product, error;
    TwoProduct(a, b, &product, &error);
    if (error != 0) {
      AddProduct(error, c);
    }
    AddProduct(product, c);
  }

  int Sign() const { return size_ == 0 ? 0 : (parts_[size_ - 1] > 0 ? 1 : -1); }

 private:
  // 24 products of three doubles have four components each.
  std::array<double, 24 * 4 + 1> parts_;
  size_t size_ = 0;
};

// Adds sign * det [a, b, c].
void AddDeterminant(const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b,
                    const Eigen::Vector3d& c,
                    double sign,
                    Expansion* sum) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    sum->AddProduct(sign * a[i], b[j], c[k]);
    sum->AddProduct(-sign * a[i], b[k], c[j]);
  }
}

// True when a - b is not rounded.
bool IsExactDifference(double a, double b) {
  double sum, error;
  TwoSum(a, -b, &sum, &error);
  return error == 0;
}

bool IsExactDifference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return IsExactDifference(a.x(), b.x()) && IsExactDifference(a.y(), b.y()) &&
         IsExactDifference(a.z(), b.z());
}

int ExactOrient3d(const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b,
                  const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d) {
  const Eigen::Vector3d ad = a - d;
  const Eigen::Vector3d bd = b - d;
  const Eigen::Vector3d cd = c - d;
  Expansion sum;
  // Coordinates that come from floats or from a grid usually take this way.
  if (IsExactDifference(a, d) && IsExactDifference(b, d) &&
      IsExactDifference(c, d)) {
    AddDeterminant(ad, bd, cd, 1, &sum);
  } else {
    AddDeterminant(a, b, c, 1, &sum);
    AddDeterminant(a, b, d, -1, &sum);
    AddDeterminant(a, c, d, 1, &sum);
    AddDeterminant(b, c, d, -1, &sum);
  }
  return sum.Sign();
}

}  // namespace

int Orient3d(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& c,
             const Eigen::Vector3d& d) {
  const Eigen::Vector3d ad = a - d;
  const Eigen::Vector3d bd = b - d;
  const Eigen::Vector3d cd = c - d;
  const double bc = bd.x() * cd.y();
  const double cb = cd.x() * bd.y();
  const double ca = cd.x() * ad.y();
  const double ac = ad.x() * cd.y();
  const double ab = ad.x() * bd.y();
  const double ba = bd.x() * ad.y();
  const double determinant =
      ad.z() * (bc - cb) + bd.z() * (ca - ac) + cd.z() * (ab - ba);
  const double permanent = (std::abs(bc) + std::abs(cb)) * std::abs(ad.z()) +
                           (std::abs(ca) + std::abs(ac)) * std::abs(bd.z()) +
                           (std::abs(ab) + std::abs(ba)) * std::abs(cd.z());
  const double bound = kBound3d * permanent;
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  // All products vanish: no rounding took place that could matter.
  if (permanent == 0) return 0;
  return ExactOrient3d(a, b, c, d);
}

int Orient2d(const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             const Eigen::Vector3d& c,
             int drop) {
  const int x = (drop + 1) % 3;
  const int y = (drop + 2) % 3;
  const double left = (a[x] - c[x]) * (b[y] - c[y]);
  const double right = (a[y] - c[y]) * (b[x] - c[x]);
  const double determinant = left - right;
  const double bound = kBound2d * (std::abs(left) + std::abs(right));
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  if (bound == 0) return 0;
  Expansion sum;
  if (IsExactDifference(a[x], c[x]) && IsExactDifference(b[y], c[y]) &&
      IsExactDifference(a[y], c[y]) && IsExactDifference(b[x], c[x])) {
    sum.AddProduct(a[x] - c[x], b[y] - c[y]);
    sum.AddProduct(c[y] - a[y], b[x] - c[x]);
    return sum.Sign();
  }
  sum.AddProduct(a[x], b[y]);
  sum.AddProduct(-a[y], b[x]);
  sum.AddProduct(b[x], c[y]);
  sum.AddProduct(-b[y], c[x]);
  sum.AddProduct(c[x], a[y]);
  sum.AddProduct(-c[y], a[x]);
  return sum.Sign();
}

}  // namespace octacut
