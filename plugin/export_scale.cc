#include "plugin/export_scale.h"

#include <fmt/format.h>

#include <cmath>

#include "colmap_io/images/marker_sightings.h"
#include "core/base/check_option.h"
#include "core/base/error.h"
#include "plugin/vector_json.h"

namespace octacut {
namespace {

// A marker's sides that differ by more than this were measured badly, or the
// marker is not flat or not square.
constexpr double kMaxSideDeviation = 0.02;

double Between(const std::vector<double>& numbers) {
  return (Eigen::Vector3d(numbers[3], numbers[4], numbers[5]) -
          Eigen::Vector3d(numbers[0], numbers[1], numbers[2]))
      .norm();
}

Json ScaleToJson(const MarkerScale& scale) {
  Json markers = Json::array();
  for (const MeasuredMarker& marker : scale.markers) {
    Json corners = Json::array();
    for (const Eigen::Vector3d& corner : marker.corners) {
      corners.push_back(VectorToJson(corner));
    }
    markers.push_back({{"id", marker.id},
                       {"views", marker.num_views},
                       {"side", marker.side},
                       {"corners", std::move(corners)}});
  }
  return {{"source", "aruco"},
          {"factor", scale.factor},
          {"reprojection_rms_pixels", scale.reprojection_rms},
          {"side_rms", scale.side_rms},
          {"side_max", scale.side_max},
          {"markers", std::move(markers)}};
}

}  // namespace

void ExportScaleOptions::Declare(OptionManager& options) {
  options.Add("scale_factor",
              &scale_factor_,
              "Millimetres per unit of the mesh; 0: not given. At most one of "
              "scale_factor, known_length and aruco_side may be given. Without "
              "any of them, a unit becomes a millimetre.");
  options.Add("known_length",
              &known_length_,
              "Distance in millimetres, measured on the object, between the "
              "two points of --between.");
  options.Add("between",
              &between_,
              "Two points x0,y0,z0,x1,y1,z1 in the frame of the mesh, for "
              "known_length.");
  options.Add("aruco_side",
              &aruco_side_,
              "Side in millimetres of the printed ArUco markers (the black "
              "square) that the photographs of the workspace show.");
  options.AddEnum("aruco_dictionary",
                  &dictionary_,
                  {{"4x4_50", MarkerDictionary::kFour50},
                   {"4x4_250", MarkerDictionary::kFour250},
                   {"5x5_250", MarkerDictionary::kFive250},
                   {"6x6_250", MarkerDictionary::kSix250},
                   {"7x7_250", MarkerDictionary::kSeven250},
                   {"original", MarkerDictionary::kOriginal},
                   {"apriltag_36h11", MarkerDictionary::kAprilTag36h11}},
                  "Dictionary that the markers are from.");
}

void ExportScaleOptions::Check() const {
  const auto check_length = [](double value, const char* name) {
    CheckOption(value >= 0 && std::isfinite(value),
                name,
                value,
                "must not be negative");
  };
  check_length(scale_factor_, "scale_factor");
  check_length(known_length_, "known_length");
  check_length(aruco_side_, "aruco_side");
  const int num_given =
      (scale_factor_ > 0) + (known_length_ > 0) + (aruco_side_ > 0);
  if (num_given > 1) {
    throw OptionError(
        "at most one of --scale_factor, --known_length and --aruco_side may be "
        "given");
  }
  if ((known_length_ > 0) == between_.empty()) {
    throw OptionError(
        "--known_length and --between must be given together: the distance and "
        "the two points that have it");
  }
  if (!between_.empty()) {
    CheckOption(between_.size() == 6 && Between(between_) > 0 &&
                    std::isfinite(Between(between_)),
                "between",
                fmt::format("{}", fmt::join(between_, ",")),
                "must be two different points x0,y0,z0,x1,y1,z1");
  }
}

ExportScale ExportScaleOptions::FromMarkers(const Workspace& workspace,
                                            const Context& context) const {
  const std::vector<MarkerSighting> sightings =
      FindMarkerSightings(workspace, dictionary_, context);
  const MarkerScale scale = NamingErrors(workspace.image_path.string(), [&] {
    return MeasureMarkerScale(sightings, aruco_side_);
  });
  context.Info(fmt::format(
      "{} ArUco markers were measured. Their sides agree to {:.2f} % and their "
      "corners to {:.2f} pixels; one unit of the mesh is {:.6g} mm.",
      scale.markers.size(),
      100 * scale.side_rms,
      scale.reprojection_rms,
      scale.factor));
  if (scale.side_max > kMaxSideDeviation) {
    context.Warn(fmt::format(
        "ArUco markers: a side differs by {:.1f} % from the others; check that "
        "all markers have the same size and lie flat",
        100 * scale.side_max));
  }
  return {scale.factor, ScaleToJson(scale)};
}

ExportScale ExportScaleOptions::Find(const std::optional<Workspace>& workspace,
                                     const Context& context) const {
  if (aruco_side_ > 0) {
    return FromMarkers(workspace.value(), context);
  }
  ExportScale scale;
  std::string source = "none";
  if (scale_factor_ > 0) {
    scale.factor = scale_factor_;
    source = "scale_factor";
  } else if (known_length_ > 0) {
    scale.factor = known_length_ / Between(between_);
    source = "known_length";
  } else {
    context.Warn(
        "no scale is given, so a unit of the mesh becomes one millimetre; see "
        "--scale_factor, --known_length and --aruco_side");
  }
  scale.json = {{"source", source}, {"factor", scale.factor}};
  return scale;
}

}  // namespace octacut
