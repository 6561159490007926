#include "core/scene/sight_lines.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/scene/pixel_distance.h"

namespace octacut {
namespace {

// Points on a line that crosses the whole box.
constexpr int kMaxLinePoints = 256;
constexpr int kMinLinePoints = 32;
// Tests of a point against a view in all, a second or two of one thread.
constexpr double kMaxTests = 6e8;
// Lines of a view; fewer than the most where there are hundreds of views.
constexpr size_t kMinLines = 100;
constexpr size_t kMaxLines = 400;
// Pixels by which masks may be too small or poses off without being
// contradicted: one, and this share of the diagonal of the rectangle around the
// mask's object. Not of its area: thin structures need as much.
constexpr double kMaskSlack = 0.015;

// What a view denies: all that is farther from the object than its slack.
class Denier {
 public:
  explicit Denier(const View& view) : view_(view) {
    const cv::Mat object = view.mask >= kObjectThreshold;
    const cv::Rect extent = cv::boundingRect(object);
    slack_ = 1 + kMaskSlack * std::hypot(extent.width, extent.height);
    // Without an object, all is background.
    closed_ = extent.empty() || !TouchesFrame(extent, object.size());
    // Beyond the frame of a closed view all is background, so that its slack
    // may reach there.
    margin_ = closed_ ? int(std::ceil(slack_)) + 1 : 0;
    cv::Mat wide;
    cv::copyMakeBorder(object,
                       wide,
                       margin_,
                       margin_,
                       margin_,
                       margin_,
                       cv::BORDER_CONSTANT,
                       cv::Scalar(0));
    near_ = PixelsNear(wide, slack_);
  }

  double Slack() const { return slack_; }

  // `point` in the camera's frame.
  bool Denies(const Eigen::Vector3d& point) const {
    if (!(point.z() > 0)) {
      return closed_;
    }
    const Eigen::Vector2d pixel = view_.camera.Project(point);
    const double x = pixel.x() + margin_;
    const double y = pixel.y() + margin_;
    if (!(x >= 0 && y >= 0 && x < near_.cols && y < near_.rows)) {
      return closed_;
    }
    return near_.at<uint8_t>(int(y), int(x)) == 0;
  }

 private:
  const View& view_;
  double slack_ = 0;
  bool closed_ = false;
  int margin_ = 0;
  cv::Mat near_;  // 255 = not denied
};

// About `count` pixels of the object, on a square grid.
std::vector<Eigen::Vector2d> GridPixels(const cv::Mat& mask, size_t count) {
  const double area = cv::countNonZero(mask >= kObjectThreshold);
  const double spacing = std::max(1.0, std::sqrt(area / double(count)));
  const auto position = [&](int i) { return int((i + 0.5) * spacing); };
  std::vector<Eigen::Vector2d> pixels;
  for (int i = 0; position(i) < mask.rows; ++i) {
    for (int j = 0; position(j) < mask.cols; ++j) {
      if (mask.at<uint8_t>(position(i), position(j)) >= kObjectThreshold) {
        pixels.emplace_back(position(j) + 0.5, position(i) + 0.5);
      }
    }
  }
  return pixels;
}

bool IsSubset(const uint64_t* a, const uint64_t* b, size_t num_words) {
  for (size_t w = 0; w < num_words; ++w) {
    if ((a[w] & ~b[w]) != 0) {
      return false;
    }
  }
  return true;
}

// Keeps the sets that hold no other one; of equal sets the first.
std::vector<uint64_t> MinimalSets(const std::vector<uint64_t>& sets,
                                  size_t num_words) {
  const size_t count = sets.size() / num_words;
  std::vector<std::pair<int, size_t>> order;
  for (size_t i = 0; i < count; ++i) {
    int size = 0;
    for (size_t w = 0; w < num_words; ++w) {
      size += std::popcount(sets[i * num_words + w]);
    }
    order.emplace_back(size, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<uint64_t> kept;
  for (const auto& [size, i] : order) {
    const uint64_t* set = sets.data() + i * num_words;
    bool is_minimal = true;
    for (size_t k = 0; is_minimal && k < kept.size(); k += num_words) {
      is_minimal = !IsSubset(kept.data() + k, set, num_words);
    }
    if (is_minimal) {
      kept.insert(kept.end(), set, set + num_words);
    }
  }
  return kept;
}

class Tracer {
 public:
  Tracer(const std::vector<View>& views,
         const std::vector<Denier>& deniers,
         const Eigen::AlignedBox3d& box,
         double spacing)
      : views_(views), deniers_(deniers), box_(box), spacing_(spacing) {}

  SightLine Trace(size_t view, const Eigen::Vector2d& pixel) const {
    const View& from = views_[view];
    const Eigen::Vector3d origin = from.Center();
    const Eigen::Vector3d direction =
        (from.cam_from_world.rotation.transpose() *
         from.camera.Unproject(pixel))
            .normalized();
    double near = 0;
    double far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double a = (box_.min()[axis] - origin[axis]) / direction[axis];
      const double b = (box_.max()[axis] - origin[axis]) / direction[axis];
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    if (!(near < far)) {
      return {};
    }
    const size_t num_words = (views_.size() + 63) / 64;
    const size_t count = size_t(std::ceil((far - near) / spacing_));
    const double step = (far - near) / double(count);
    std::vector<uint64_t> denials(count * num_words, 0);
    for (size_t v = 0; v < views_.size(); ++v) {
      if (v == view) {
        continue;
      }
      const Rigid3d& pose = views_[v].cam_from_world;
      const Eigen::Vector3d first = pose * (origin + near * direction);
      const Eigen::Vector3d along = pose.rotation * direction * step;
      for (size_t i = 0; i < count; ++i) {
        if (deniers_[v].Denies(first + (double(i) + 0.5) * along)) {
          denials[i * num_words + v / 64] |= uint64_t{1} << v % 64;
        }
      }
    }
    return {MinimalSets(denials, num_words)};
  }

 private:
  const std::vector<View>& views_;
  const std::vector<Denier>& deniers_;
  const Eigen::AlignedBox3d box_;
  const double spacing_;
};

}  // namespace

SightLines TraceSightLines(const std::vector<View>& views,
                           const Eigen::AlignedBox3d& box,
                           const Context& context) {
  std::vector<Denier> deniers;
  deniers.reserve(views.size());
  // Points as close as the slack: structures that are thinner are not missed,
  // since slack is on both sides of them.
  double spacing = box.diagonal().norm() / kMinLinePoints;
  for (const View& view : views) {
    deniers.emplace_back(view);
    const double depth = (view.cam_from_world * box.center()).z();
    if (depth > 0) {
      spacing =
          std::min(spacing, deniers.back().Slack() * depth / view.camera.fx);
    }
  }
  spacing = std::max(spacing, box.diagonal().norm() / kMaxLinePoints);
  const double tests_per_line =
      double(views.size()) * box.diagonal().norm() / spacing;
  const size_t count =
      std::clamp(size_t(kMaxTests / (tests_per_line * double(views.size()))),
                 kMinLines,
                 kMaxLines);

  SightLines lines;
  lines.num_words = (views.size() + 63) / 64;
  lines.of_views.resize(views.size());
  const Tracer tracer(views, deniers, box, spacing);
  ParallelEach(context, views.size(), 1, [&](size_t v) {
    for (const Eigen::Vector2d& pixel : GridPixels(views[v].mask, count)) {
      lines.of_views[v].push_back(tracer.Trace(v, pixel));
    }
  });
  return lines;
}

}  // namespace octacut
