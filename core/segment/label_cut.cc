#include "core/segment/label_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>
#include <vector>

#include "core/segment/labels.h"

namespace octacut {
namespace {

// Half of the eight neighbours; the others have the pixel for theirs.
const std::array<cv::Point, 4> kNeighbours = {
    cv::Point(1, 0), cv::Point(-1, 1), cv::Point(0, 1), cv::Point(1, 1)};

float SquaredDifference(const cv::Vec3b& a, const cv::Vec3b& b) {
  float sum = 0;
  for (int c = 0; c < 3; ++c) {
    const float difference = float(a[c]) - float(b[c]);
    sum += difference * difference;
  }
  return sum;
}

class Cutter {
 public:
  Cutter(const cv::Mat& image,
         const cv::Mat& log_odds,
         float smoothness,
         cv::Mat* labels)
      : image_(image),
        log_odds_(log_odds),
        smoothness_(smoothness),
        labels_(*labels),
        nodes_(labels->size(), -1) {}

  void Run() {
    for (int y = 0; y < labels_.rows; ++y) {
      for (int x = 0; x < labels_.cols; ++x) {
        if (labels_.at<uint8_t>(y, x) == kNoLabel) {
          nodes_(y, x) = int(pixels_.size());
          pixels_.emplace_back(x, y);
        }
      }
    }
    if (pixels_.empty()) {
      return;
    }
    beta_ = 1 / std::max(1e-3f, 2 * MeanDifference());
    graph_.create(unsigned(pixels_.size() + 1),
                  unsigned(8 * pixels_.size() + 2));
    for (const cv::Point& p : pixels_) {
      const float odds = log_odds_.at<float>(p);
      graph_.addTermWeights(
          graph_.addVtx(), std::max(odds, 0.0f), std::max(-odds, 0.0f));
    }
    // A graph without any edge is refused.
    graph_.addEdges(0, graph_.addVtx(), 0, 0);
    ForEachPair(
        [this](const cv::Point& p, const cv::Point& q) { AddPair(p, q); });
    graph_.maxFlow();
    for (size_t i = 0; i < pixels_.size(); ++i) {
      labels_.at<uint8_t>(pixels_[i]) =
          graph_.inSourceSegment(int(i)) ? kObjectLabel : kSurroundingsLabel;
    }
  }

 private:
  // Every pair of neighbours of which at least one is to be decided.
  template <typename Body>
  void ForEachPair(const Body& body) const {
    const cv::Rect frame(cv::Point(0, 0), labels_.size());
    for (const cv::Point& p : pixels_) {
      for (const cv::Point& step : kNeighbours) {
        if (frame.contains(p + step)) {
          body(p, p + step);
        }
        // The pair with a decided pixel is met from this side only.
        if (frame.contains(p - step) && nodes_(p - step) < 0) {
          body(p, p - step);
        }
      }
    }
  }

  float MeanDifference() const {
    double sum = 0;
    size_t count = 0;
    ForEachPair([&](const cv::Point& p, const cv::Point& q) {
      sum +=
          SquaredDifference(image_.at<cv::Vec3b>(p), image_.at<cv::Vec3b>(q));
      ++count;
    });
    return count == 0 ? 0 : float(sum / double(count));
  }

  void AddPair(const cv::Point& p, const cv::Point& q) {
    const bool diagonal = p.x != q.x && p.y != q.y;
    const float weight =
        smoothness_ *
        std::exp(-beta_ * SquaredDifference(image_.at<cv::Vec3b>(p),
                                            image_.at<cv::Vec3b>(q))) /
        (diagonal ? std::sqrt(2.0f) : 1.0f);
    if (nodes_(q) >= 0) {
      graph_.addEdges(nodes_(p), nodes_(q), weight, weight);
    } else if (labels_.at<uint8_t>(q) == kObjectLabel) {
      graph_.addTermWeights(nodes_(p), weight, 0);
    } else {
      graph_.addTermWeights(nodes_(p), 0, weight);
    }
  }

  const cv::Mat& image_;
  const cv::Mat& log_odds_;
  const float smoothness_;
  cv::Mat& labels_;
  cv::Mat_<int> nodes_;
  std::vector<cv::Point> pixels_;
  float beta_ = 0;
  cv::detail::GCGraph<float> graph_;
};

}  // namespace

void CutLabels(const cv::Mat& image,
               const cv::Mat& log_odds,
               float smoothness,
               cv::Mat* labels) {
  Cutter(image, log_odds, smoothness, labels).Run();
}

}  // namespace octacut
