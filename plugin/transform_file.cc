#include "plugin/transform_file.h"

#include <fmt/format.h>

#include <cmath>
#include <Eigen/Core>
#include <Eigen/LU>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>

#include "colmap_io/files/byte_order_mark.h"
#include "colmap_io/files/read_file.h"
#include "core/base/error.h"

namespace octacut {
namespace {

constexpr double kRigidTolerance = 1e-5;

Eigen::Matrix4d MatrixOf(const Similarity3d& transform) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = transform.scale * transform.rotation;
  matrix.topRightCorner<3, 1>() = transform.translation;
  return matrix;
}

}  // namespace

Similarity3d ReadTransform(const std::filesystem::path& path) {
  const std::string text = ReadFile(path);
  std::string_view numbers = text;
  SkipByteOrderMark(&numbers);
  std::istringstream stream{std::string(numbers)};
  stream.imbue(std::locale::classic());
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i) {
    if (!(stream >> matrix(i / 4, i % 4)) ||
        !std::isfinite(matrix(i / 4, i % 4))) {
      throw InputError(fmt::format(
          "{}: must hold the 16 numbers of a 4 x 4 matrix; number {} cannot be "
          "read",
          path.string(),
          i + 1));
    }
  }
  std::string rest;
  if (stream >> rest) {
    throw InputError(fmt::format(
        "{}: more than 16 numbers, first \"{}\"", path.string(), rest));
  }
  if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    throw InputError(
        fmt::format("{}: the last row must be 0 0 0 1", path.string()));
  }
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  Similarity3d transform;
  transform.scale = std::cbrt(linear.determinant());
  transform.rotation = linear / transform.scale;
  transform.translation = matrix.topRightCorner<3, 1>();
  const double error = (transform.rotation * transform.rotation.transpose() -
                        Eigen::Matrix3d::Identity())
                           .norm();
  if (!(transform.scale > 0) || !(error <= kRigidTolerance)) {
    throw InputError(fmt::format(
        "{}: the first three rows and columns must be a rotation times a "
        "positive scale",
        path.string()));
  }
  return transform;
}

void WriteTransform(const std::filesystem::path& path,
                    const Similarity3d& transform,
                    AtomicFiles* files) {
  const Eigen::Matrix4d matrix = MatrixOf(transform);
  files->Write(path, [&](std::ostream& stream) {
    for (int row = 0; row < 4; ++row) {
      stream << fmt::format("{} {} {} {}\n",
                            matrix(row, 0),
                            matrix(row, 1),
                            matrix(row, 2),
                            matrix(row, 3));
    }
  });
}

Json TransformToJson(const Similarity3d& transform) {
  const Eigen::Matrix4d matrix = MatrixOf(transform);
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) {
    rows.push_back(
        {matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
  }
  return rows;
}

}  // namespace octacut
