#include "plugin/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

namespace octacut {
namespace {

constexpr int kColumns = 6;
constexpr int kTile = 320;  // pixels along a side
constexpr int kTextHeight = 18;
// JPEG ends at 65500 pixels: of more than some 1200 views, the sheet shows
// those with the least confidence.
constexpr int kMaxHeight = 65000;

cv::Scalar ColourOf(MaskStatus status) {
  switch (status) {
    case MaskStatus::kExtracted:
      return {0, 255, 0};
    case MaskStatus::kUnsure:
      return {0, 0, 255};
    case MaskStatus::kGiven:
      return {255, 128, 0};
  }
  return {};
}

cv::Size SizeOnSheet(const cv::Mat& image) {
  const double factor = double(kTile) / std::max(image.cols, image.rows);
  return {std::clamp(int(std::lround(image.cols * factor)), 1, kTile),
          std::clamp(int(std::lround(image.rows * factor)), 1, kTile)};
}

cv::Mat DrawTile(const cv::Mat& image,
                 const cv::Mat& mask,
                 const ListedMask& listed,
                 int height) {
  cv::Mat tile(height, kTile, CV_8UC3, cv::Scalar::all(255));
  cv::Mat picture;
  cv::resize(image, picture, SizeOnSheet(image), 0, 0, cv::INTER_AREA);
  cv::Mat object;
  cv::resize(mask, object, picture.size(), 0, 0, cv::INTER_NEAREST);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(object, outlines, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  cv::drawContours(picture, outlines, -1, ColourOf(listed.status), 1);
  picture.copyTo(tile(cv::Rect(cv::Point(0, kTextHeight), picture.size())));
  const std::string text =
      listed.status == MaskStatus::kGiven
          ? fmt::format("{}  given", listed.image)
          : fmt::format(
                "{}  {:.2f}{}",
                listed.image,
                listed.confidence,
                listed.status == MaskStatus::kUnsure ? "  no mask" : "");
  cv::putText(tile,
              text,
              {2, kTextHeight - 5},
              cv::FONT_HERSHEY_SIMPLEX,
              0.4,
              cv::Scalar::all(0),
              1,
              cv::LINE_AA);
  return tile;
}

}  // namespace

cv::Mat DrawContactSheet(std::span<const UnsegmentedView> views,
                         std::span<const cv::Mat> masks,
                         const MaskList& list) {
  std::vector<size_t> order(views.size());
  std::iota(order.begin(), order.end(), size_t{0});
  const auto rank = [&](size_t i) {
    const ListedMask& listed = list.views[i];
    return std::pair(listed.status != MaskStatus::kUnsure, listed.confidence);
  };
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return rank(a) < rank(b);
  });
  int height = 0;
  for (const UnsegmentedView& view : views) {
    height = std::max(height, SizeOnSheet(view.image).height + kTextHeight);
  }
  const int rows = std::min((int(views.size()) + kColumns - 1) / kColumns,
                            kMaxHeight / std::max(height, 1));
  order.resize(std::min(order.size(), size_t(rows) * kColumns));
  cv::Mat sheet(rows * height, kColumns * kTile, CV_8UC3, cv::Scalar::all(255));
  for (size_t k = 0; k < order.size(); ++k) {
    const size_t i = order[k];
    const cv::Mat tile =
        DrawTile(views[i].image, masks[i], list.views[i], height);
    tile.copyTo(sheet(cv::Rect(
        cv::Point(int(k) % kColumns * kTile, int(k) / kColumns * height),
        tile.size())));
  }
  return sheet;
}

}  // namespace octacut
