#include "tests/bench/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"

namespace octacut {
namespace {

constexpr int kWidth = 900;
constexpr int kHeight = 520;
const cv::Rect kPlot(70, 50, 620, 400);
const std::array<cv::Scalar, 5> kColors = {cv::Scalar(40, 40, 200),
                                           cv::Scalar(200, 140, 40),
                                           cv::Scalar(60, 160, 60),
                                           cv::Scalar(170, 60, 150),
                                           cv::Scalar(40, 150, 220)};

struct Range {
  double low = 1e300, high = -1e300;
  void Add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double Share(double value) const { return (value - low) / (high - low); }
};

void PutText(cv::Mat& image,
             const std::string& text,
             const cv::Point& at,
             double scale = 0.5) {
  cv::putText(image,
              text,
              at,
              cv::FONT_HERSHEY_SIMPLEX,
              scale,
              cv::Scalar(30, 30, 30),
              1,
              cv::LINE_AA);
}

}  // namespace

void DrawChart(const Chart& chart, const std::string& path) {
  cv::Mat image(kHeight, kWidth, CV_8UC3, cv::Scalar(255, 255, 255));
  Range x, y;
  for (const Curve& curve : chart.curves) {
    for (const auto& [px, py] : curve.points) {
      x.Add(px);
      y.Add(py);
    }
  }
  const double margin = 0.05 * (y.high - y.low);
  y = {y.low - margin, y.high + margin};
  const auto at = [&](double px, double py) {
    return cv::Point(kPlot.x + int(x.Share(px) * kPlot.width),
                     kPlot.y + int((1 - y.Share(py)) * kPlot.height));
  };
  const cv::Scalar grey(215, 215, 215);
  for (int k = 0; k <= 5; ++k) {
    const double value = y.low + k * (y.high - y.low) / 5;
    cv::line(image, at(x.low, value), at(x.high, value), grey);
    PutText(image,
            fmt::format("{:.2f}", value),
            at(x.low, value) - cv::Point(50, -5));
  }
  for (const auto& [px, name] : chart.ticks) {
    cv::line(image, at(px, y.low), at(px, y.high), grey);
    PutText(image, name, at(px, y.low) + cv::Point(-15, 22));
  }
  cv::rectangle(image, kPlot, cv::Scalar(120, 120, 120));
  for (size_t k = 0; k < chart.curves.size(); ++k) {
    const Curve& curve = chart.curves[k];
    const cv::Scalar& color = kColors[k % kColors.size()];
    for (size_t i = 1; i < curve.points.size(); ++i) {
      cv::line(image,
               at(curve.points[i - 1].first, curve.points[i - 1].second),
               at(curve.points[i].first, curve.points[i].second),
               color,
               2,
               cv::LINE_AA);
    }
    const cv::Point legend(kPlot.x + kPlot.width + 15,
                           kPlot.y + 20 + 26 * int(k));
    cv::line(image, legend, legend + cv::Point(30, 0), color, 3);
    PutText(image, curve.name, legend + cv::Point(38, 5));
  }
  PutText(image, chart.title, {kPlot.x, 32}, 0.6);
  if (!cv::imwrite(path, image)) {
    throw InputError(path + ": cannot be written");
  }
}

}  // namespace octacut
