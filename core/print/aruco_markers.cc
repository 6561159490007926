#include "core/print/aruco_markers.h"

#include <algorithm>
#include <opencv2/aruco.hpp>

namespace octacut {
namespace {

cv::Ptr<cv::aruco::Dictionary> DictionaryOf(MarkerDictionary dictionary) {
  const auto name = [&] {
    switch (dictionary) {
      case MarkerDictionary::kFour50:
        return cv::aruco::DICT_4X4_50;
      case MarkerDictionary::kFour250:
        return cv::aruco::DICT_4X4_250;
      case MarkerDictionary::kFive250:
        return cv::aruco::DICT_5X5_250;
      case MarkerDictionary::kSix250:
        return cv::aruco::DICT_6X6_250;
      case MarkerDictionary::kSeven250:
        return cv::aruco::DICT_7X7_250;
      case MarkerDictionary::kOriginal:
        return cv::aruco::DICT_ARUCO_ORIGINAL;
      case MarkerDictionary::kAprilTag36h11:
        return cv::aruco::DICT_APRILTAG_36h11;
    }
    return cv::aruco::DICT_4X4_50;
  }();
  return cv::aruco::getPredefinedDictionary(name);
}

}  // namespace

std::vector<DetectedMarker> DetectMarkers(const cv::Mat& image,
                                          MarkerDictionary dictionary) {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  cv::aruco::detectMarkers(
      image, DictionaryOf(dictionary), corners, ids, parameters);
  std::vector<DetectedMarker> markers;
  for (size_t i = 0; i < ids.size(); ++i) {
    if (std::count(ids.begin(), ids.end(), ids[i]) > 1) {
      continue;
    }
    DetectedMarker& marker = markers.emplace_back();
    marker.id = ids[i];
    for (size_t k = 0; k < marker.corners.size(); ++k) {
      marker.corners[k] = {corners[i][k].x + 0.5, corners[i][k].y + 0.5};
    }
  }
  std::sort(markers.begin(),
            markers.end(),
            [](const DetectedMarker& a, const DetectedMarker& b) {
              return a.id < b.id;
            });
  return markers;
}

}  // namespace octacut
