#include "core/scene/bites.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/base/parallel.h"
#include "core/scene/denied_cells.h"
#include "core/scene/outline_distance.h"
#include "core/scene/pixel_distance.h"
#include "core/scene/silhouette_box.h"

namespace octacut {
namespace {

constexpr size_t kMinViews = 4;
constexpr size_t kMinViewsForTwo = 8;
constexpr int kBoxLevel = 5;
// Pixels by which right masks may be wrong.
constexpr double kSlack = 1;
// Views that a bite leaves pixels unexplained in, and their share of all.
constexpr size_t kMinWitnesses = 3;
constexpr size_t kWitnessDivisor = 4;
// The largest bite in units of the object's area, and the pixels by which a
// bite is widened over the object.
constexpr double kMaxShare = 0.05;
constexpr int kMargin = 3;
// Radii of cells that a bite may go on in depth where it meets the mask.
constexpr double kDepthMargin = 8;

using CellNumbers = std::vector<size_t>;

bool Mark(const Eigen::Vector2d& pixel, cv::Mat* marked) {
  const bool is_within = pixel.x() >= 0 && pixel.y() >= 0 &&
                         pixel.x() < marked->cols && pixel.y() < marked->rows;
  if (is_within) {
    marked->at<uint8_t>(int(pixel.y()), int(pixel.x())) = 255;
  }
  return is_within;
}

class BiteFinder {
 public:
  BiteFinder(const std::vector<View>& views, double mask_tolerance)
      : views_(views),
        mask_tolerance_(mask_tolerance),
        max_denials_(views.size() >= kMinViewsForTwo ? 2 : 1),
        min_witnesses_(
            std::max(kMinWitnesses, views.size() / kWitnessDivisor)) {}

  std::vector<Bite> Run(const Context& context) {
    const Eigen::AlignedBox3d box =
        BoxOfMostSilhouettes(views_, max_denials_, kBoxLevel, context);
    if (box.isEmpty()) {
      return {};
    }
    for (const View& view : views_) {
      outlines_.emplace_back(view);
    }
    cells_ =
        FindDeniedCells(views_, outlines_, box, max_denials_, kSlack, context);
    FindUnexplained(context);
    std::vector<Bite> bites;
    for (const CellNumbers& cells : GroupsByWeight()) {
      Settle(cells, &bites);
    }
    return bites;
  }

 private:
  Eigen::Vector2d Project(size_t view, const Eigen::Vector3d& point) const {
    const View& v = views_[view];
    const Eigen::Vector3d in_cam = v.cam_from_world * point;
    return in_cam.z() > 0 ? v.camera.Project(in_cam)
                          : Eigen::Vector2d::Constant(-1);
  }

  // Marks those pixels of the view that the cells may take.
  template <typename Centers>
  cv::Mat ProjectedCells(size_t view, const Centers& centers) const {
    cv::Mat marked = cv::Mat::zeros(views_[view].mask.size(), CV_8UC1);
    double radius = 0;
    for (const Eigen::Vector3d& center : centers) {
      const double of_cell = CellRadius(views_[view], center, cells_.radius);
      if (std::isfinite(of_cell) && Mark(Project(view, center), &marked)) {
        radius = std::max(radius, of_cell);
      }
    }
    return PixelsNear(marked, radius + kSlack);
  }

  void FindUnexplained(const Context& context) {
    unexplained_.resize(views_.size());
    ParallelEach(context, views_.size(), 1, [&](size_t v) {
      const cv::Mat object = views_[v].mask >= kObjectThreshold;
      unexplained_[v] = object & ~ProjectedCells(v, cells_.shown);
      DropUnknown(object, &unexplained_[v]);
    });
  }

  // What goes on beyond the frame may be explained there, and what is too large
  // for a bite has other reasons.
  static void DropUnknown(const cv::Mat& object, cv::Mat* unexplained) {
    const double most = kMaxShare * cv::countNonZero(object);
    cv::Mat labels;
    cv::Mat stats;
    cv::Mat centroids;
    const int count = cv::connectedComponentsWithStats(
        *unexplained, labels, stats, centroids);
    for (int label = 1; label < count; ++label) {
      const int* row = stats.ptr<int>(label);
      const cv::Rect box(row[cv::CC_STAT_LEFT],
                         row[cv::CC_STAT_TOP],
                         row[cv::CC_STAT_WIDTH],
                         row[cv::CC_STAT_HEIGHT]);
      if (TouchesFrame(box, object.size()) || row[cv::CC_STAT_AREA] > most) {
        (*unexplained)(box).setTo(0, labels(box) == label);
      }
    }
  }

  // Views that show the cell and have no other explanation.
  size_t CountWitnesses(size_t cell) const {
    const Deniers& deniers = cells_.deniers[cell];
    size_t count = 0;
    for (size_t v = 0; v < views_.size(); ++v) {
      if (int(v) == deniers[0] || int(v) == deniers[1]) {
        continue;
      }
      const Eigen::Vector2d pixel = Project(v, cells_.denied[cell]);
      const cv::Mat& unexplained = unexplained_[v];
      count += pixel.x() >= 0 && pixel.y() >= 0 &&
               pixel.x() < unexplained.cols && pixel.y() < unexplained.rows &&
               unexplained.at<uint8_t>(int(pixel.y()), int(pixel.x())) != 0;
    }
    return count >= min_witnesses_ ? count : 0;
  }

  // Cells with witnesses that the same views deny; those with most witnesses
  // first.
  std::vector<CellNumbers> GroupsByWeight() const {
    std::map<Deniers, std::pair<size_t, CellNumbers>> groups;
    for (size_t i = 0; i < cells_.denied.size(); ++i) {
      if (const size_t count = CountWitnesses(i)) {
        auto& [weight, cells] = groups[cells_.deniers[i]];
        weight += count;
        cells.push_back(i);
      }
    }
    std::vector<std::pair<size_t, CellNumbers>> sorted;
    sorted.reserve(groups.size());
    for (auto& [deniers, group] : groups) {
      sorted.push_back(std::move(group));
    }
    std::stable_sort(
        sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
          return a.first > b.first;
        });
    std::vector<CellNumbers> result;
    result.reserve(sorted.size());
    for (auto& [weight, cells] : sorted) {
      result.push_back(std::move(cells));
    }
    return result;
  }

  void Settle(CellNumbers cells, std::vector<Bite>* bites) {
    std::erase_if(cells,
                  [&](size_t cell) { return CountWitnesses(cell) == 0; });
    if (cells.empty()) {
      return;
    }
    std::vector<Eigen::Vector3d> centers;
    centers.reserve(cells.size());
    for (const size_t cell : cells) {
      centers.push_back(cells_.denied[cell]);
    }
    const Deniers deniers = cells_.deniers[cells.front()];
    std::vector<Bite> found;
    for (const int view : deniers) {
      if (view >= 0) {
        Bite bite = BiteOf(size_t(view), centers, deniers);
        if (bite.num_pixels == 0) {
          return;
        }
        found.push_back(std::move(bite));
      }
    }
    for (size_t v = 0; v < views_.size(); ++v) {
      if (int(v) != deniers[0] && int(v) != deniers[1]) {
        unexplained_[v].setTo(0, ProjectedCells(v, centers));
      }
    }
    bites->insert(bites->end(), found.begin(), found.end());
  }

  // The background of the view where its lines of sight meet the cells and no
  // mask but the deniers' stands against it.
  Bite BiteOf(size_t view,
              const std::vector<Eigen::Vector3d>& centers,
              const Deniers& deniers) const {
    const View& of = views_[view];
    Eigen::AlignedBox1d depths;
    for (const Eigen::Vector3d& center : centers) {
      depths.extend(
          Eigen::Matrix<double, 1, 1>((of.cam_from_world * center).z()));
    }
    // What is that near to the mask counts as explained, so that the cells do
    // not reach up to it.
    const double reach =
        2 * (CellRadius(of, centers.front(), cells_.radius) + kSlack) + kMargin;
    const cv::Mat object = of.mask >= kObjectThreshold;
    const cv::Mat projected = ProjectedCells(view, centers);
    cv::Mat gap = (projected |
                   (PixelsNear(projected, reach) & PixelsNear(object, reach))) &
                  ~object;
    std::vector<cv::Point> pixels;
    cv::findNonZero(gap, pixels);
    for (const cv::Point& pixel : pixels) {
      if (!IsLeft(view, pixel, depths, deniers)) {
        gap.at<uint8_t>(pixel) = 0;
      }
    }
    Bite bite;
    bite.view = view;
    KeepBites(view, &gap);
    bite.num_pixels = size_t(cv::countNonZero(gap));
    bite.pixels = gap | (PixelsNear(gap, kMargin) & object);
    return bite;
  }

  bool IsLeft(size_t view,
              const cv::Point& pixel,
              const Eigen::AlignedBox1d& depths,
              const Deniers& deniers) const {
    const View& of = views_[view];
    const Rigid3d world_from_cam = of.cam_from_world.Inverse();
    const Eigen::Vector3d ray =
        of.camera.Unproject({pixel.x + 0.5, pixel.y + 0.5});
    const double margin = kDepthMargin * cells_.radius;
    const double first = depths.min().x() - margin;
    const double last = depths.max().x() + margin;
    double depth = first;
    while (depth <= last) {
      const Eigen::Vector3d point = world_from_cam * (depth * ray);
      bool is_left = depth > 0;
      for (size_t v = 0; is_left && v < views_.size(); ++v) {
        is_left = int(v) == deniers[0] || int(v) == deniers[1] ||
                  outlines_[v].At(Project(v, point)) <= kSlack;
      }
      if (is_left) {
        return true;
      }
      depth += cells_.radius / 2;
    }
    return false;
  }

  // Drops what is too large or not deep.
  void KeepBites(size_t view, cv::Mat* gap) const {
    const View& of = views_[view];
    const double most =
        kMaxShare * cv::countNonZero(of.mask >= kObjectThreshold);
    const double min_depth = std::max(kSlack, 2 * mask_tolerance_ * of.scale);
    cv::Mat labels;
    const int count = cv::connectedComponents(*gap, labels);
    std::vector<double> areas(size_t(count), 0);
    std::vector<double> depths(size_t(count), 0);
    std::vector<cv::Point> pixels;
    cv::findNonZero(*gap, pixels);
    for (const cv::Point& pixel : pixels) {
      const auto label = size_t(labels.at<int>(pixel));
      areas[label] += 1;
      depths[label] = std::max(
          depths[label], outlines_[view].At({pixel.x + 0.5, pixel.y + 0.5}));
    }
    for (const cv::Point& pixel : pixels) {
      const auto label = size_t(labels.at<int>(pixel));
      if (areas[label] > most || depths[label] <= min_depth) {
        gap->at<uint8_t>(pixel) = 0;
      }
    }
  }

  const std::vector<View>& views_;
  const double mask_tolerance_;
  const size_t max_denials_;
  const size_t min_witnesses_;
  std::vector<OutlineDistance> outlines_;
  DeniedCells cells_;
  std::vector<cv::Mat> unexplained_;  // CV_8UC1, 255 = is
};

}  // namespace

std::vector<Bite> FindBites(const std::vector<View>& views,
                            double mask_tolerance,
                            const Context& context) {
  if (views.size() < kMinViews) {
    return {};
  }
  return BiteFinder(views, mask_tolerance).Run(context);
}

}  // namespace octacut
