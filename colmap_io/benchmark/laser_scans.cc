#include "colmap_io/benchmark/laser_scans.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <utility>

#include "colmap_io/mesh/mesh_io.h"
#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

// Projects have their matrices in six digits.
constexpr double kRigidTolerance = 1e-4;

[[noreturn]] void Fail(const fs::path& path,
                       size_t index,
                       const std::string& problem) {
  throw InputError(
      fmt::format("{}: MLMesh {}: {}", path.string(), index, problem));
}

Rigid3d ReadPose(const fs::path& path, size_t index, const char* text) {
  std::istringstream stream(text == nullptr ? "" : text);
  stream.imbue(std::locale::classic());
  double numbers[16];
  for (double& number : numbers) {
    if (!(stream >> number) || !std::isfinite(number)) {
      Fail(path, index, "MLMatrix44 must hold 16 numbers");
    }
  }
  Rigid3d pose;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      pose.rotation(row, column) = numbers[4 * row + column];
    }
    pose.translation[row] = numbers[4 * row + 3];
  }
  const double error =
      (pose.rotation * pose.rotation.transpose() - Eigen::Matrix3d::Identity())
          .norm();
  if (!(error <= kRigidTolerance) || numbers[12] != 0 || numbers[13] != 0 ||
      numbers[14] != 0 || numbers[15] != 1) {
    Fail(path, index, "MLMatrix44 must be a rotation and a translation");
  }
  return pose;
}

}  // namespace

std::vector<LaserScan> ReadLaserScans(const fs::path& path) {
  tinyxml2::XMLDocument document;
  if (document.LoadFile(path.c_str()) != tinyxml2::XML_SUCCESS) {
    throw InputError(fmt::format("{}: cannot be read as a MeshLab project: {}",
                                 path.string(),
                                 document.ErrorName()));
  }
  tinyxml2::XMLHandle handle(&document);
  const tinyxml2::XMLElement* element =
      handle.FirstChildElement("MeshLabProject")
          .FirstChildElement("MeshGroup")
          .FirstChildElement("MLMesh")
          .ToElement();
  std::vector<LaserScan> scans;
  for (; element != nullptr; element = element->NextSiblingElement("MLMesh")) {
    const char* filename = element->Attribute("filename");
    if (filename == nullptr || *filename == '\0') {
      Fail(path, scans.size(), "has no filename");
    }
    const tinyxml2::XMLElement* matrix =
        element->FirstChildElement("MLMatrix44");
    LaserScan scan;
    scan.world_from_scan = ReadPose(
        path, scans.size(), matrix == nullptr ? nullptr : matrix->GetText());
    scan.points = ReadMesh(path.parent_path() / filename).mesh.positions;
    if (scan.points.empty()) {
      Fail(path, scans.size(), fmt::format("{} has no points", filename));
    }
    scans.push_back(std::move(scan));
  }
  if (scans.empty()) {
    throw InputError(fmt::format(
        "{}: the MeshLab project has no MLMesh in a MeshGroup", path.string()));
  }
  return scans;
}

}  // namespace octacut
