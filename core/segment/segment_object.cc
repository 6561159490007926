#include "core/segment/segment_object.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/segment/appearance.h"
#include "core/segment/label_cut.h"
#include "core/segment/labels.h"
#include "core/segment/occupancy.h"
#include "core/segment/other_views.h"
#include "core/segment/pixel_features.h"
#include "core/segment/view_confidence.h"

namespace octacut {
namespace {

constexpr int kCoarseResolution = 96;
constexpr int kFineResolution = 128;
constexpr int kCoarseRounds = 4;
constexpr int kFineRounds = 3;
// The middle, in radii of the search region; the outside begins at twice that.
// A plate under the object, which the frames show whole as well, is left out by
// the first one. An object with a hole where the cameras look needs the second,
// which is tried where the first one leaves more than this part of the views in
// doubt.
constexpr std::array<double, 2> kMiddles = {0.25, 0.5};
constexpr double kFewDoubts = 0.1;
// Space around the object in the finer grid, in edges of its box.
constexpr double kMargin = 0.15;
// Log odds beyond which a pixel is taken for sure and learned from.
constexpr float kSure = 1;
// The smoothness of the cut in each view: a border of one pixel's length costs
// as much as the certain evidence of one view.
constexpr float kSmoothness = kMaxViewLogOdds;
// Before the object is known, the middle shows surroundings as well, so colours
// count for object only where they are this much more frequent in it.
constexpr float kFirstDoubt = 1.5f;
// Pixels around a point of the stand whose colours are learned.
constexpr int kPointRadius = 1;

// Log odds of the object from what shows the stand, which outweighs any colour,
// and from what hides it.
cv::Mat StandEvidence(const cv::Mat& stand) {
  return kMaxViewLogOdds * (cv::max(-stand, 0) - 2 * cv::max(stand, 0));
}

void ClampToOneViewsWord(cv::Mat* log_odds) {
  cv::max(*log_odds, -kMaxViewLogOdds, *log_odds);
  cv::min(*log_odds, kMaxViewLogOdds, *log_odds);
}

class Segmenter {
 public:
  Segmenter(const SegmentationInput& input, const Context& context)
      : input_(input), context_(context) {
    for (const UnsegmentedView& view : input.views) {
      poses_.push_back(view.pose);
    }
    result_.region = FindSearchRegion(poses_, input.box);
    const size_t count = input.views.size();
    features_.resize(count);
    labels_.resize(count);
    colours_.resize(count);
    result_.views.resize(count);
  }

  Segmentation Run();

 private:
  cv::Mat FirstLabels(size_t view, double middle) const;
  bool FindObject(double middle);
  size_t CountDoubts() const;
  bool HasObjectLabels() const;
  // Whether what turns in a view is known, and where the stand is: all else
  // that turns is object, whatever the surroundings look like.
  bool IsObjectOrStand(size_t view) const {
    return !input_.views[view].above_plate.empty();
  }
  // Whether that is so in all views: what is neither is known as background.
  bool HasNothingElse() const {
    for (size_t i = 0; i < poses_.size(); ++i) {
      if (!IsObjectOrStand(i)) {
        return false;
      }
    }
    return true;
  }
  void Learn(bool own_objects);
  bool Round(const BoundingCube& cube, int resolution);
  void Relabel(size_t view);
  void CutView(size_t view);
  void ApplyGivenLabels(size_t view, cv::Mat* labels) const;

  const SegmentationInput& input_;
  const Context& context_;
  std::vector<Pose> poses_;
  std::vector<cv::Mat> features_;
  std::vector<cv::Mat> labels_;
  std::vector<cv::Mat> colours_;  // log odds from colours
  Segmentation result_;
};

// Middle and outside by the distances of rays from the centre.
cv::Mat Segmenter::FirstLabels(size_t view, double middle) const {
  const cv::Mat distances = DistancesFromCenter(poses_[view], result_.region);
  cv::Mat labels(distances.size(), CV_8U, cv::Scalar(kNoLabel));
  labels.setTo(kObjectLabel, distances < middle);
  labels.setTo(kSurroundingsLabel, distances >= 2 * middle);
  return labels;
}

void Segmenter::ApplyGivenLabels(size_t view, cv::Mat* labels) const {
  const cv::Rect frame(cv::Point(0, 0), labels->size());
  for (const Eigen::Vector2d& pixel : input_.views[view].stand_points) {
    const cv::Point corner(int(std::floor(pixel.x())) - kPointRadius,
                           int(std::floor(pixel.y())) - kPointRadius);
    (*labels)(
        cv::Rect(corner, cv::Size(2 * kPointRadius + 1, 2 * kPointRadius + 1)) &
        frame)
        .setTo(kSurroundingsLabel);
  }
  const cv::Mat& stand = input_.views[view].stand;
  if (!stand.empty()) {
    labels->setTo(kSurroundingsLabel, stand >= 1);
  }
  const cv::Mat& given = input_.views[view].labels;
  if (given.empty()) {
    return;
  }
  given.copyTo(*labels, given != kNoLabel);
  if (IsObjectOrStand(view)) {
    labels->setTo(kNoLabel, given == kSurroundingsLabel);
  }
}

void Segmenter::Learn(bool own_objects) {
  const Appearance appearance(features_, labels_, own_objects, context_);
  ParallelEach(context_, poses_.size(), 1, [&](size_t i) {
    colours_[i] = appearance.LogOdds(i, features_[i]);
    cv::Mat& colours = colours_[i];
    if (!own_objects) {
      colours -= kFirstDoubt;
    }
    ClampToOneViewsWord(&colours);
    if (!input_.views[i].stand.empty()) {
      colours += StandEvidence(input_.views[i].stand);
      ClampToOneViewsWord(&colours);
    }
    const cv::Mat& given = input_.views[i].labels;
    if (!given.empty()) {
      colours.setTo(2 * kMaxViewLogOdds, given == kObjectLabel);
      colours.setTo(-2 * kMaxViewLogOdds, given == kSurroundingsLabel);
    }
  });
}

void Segmenter::Relabel(size_t view) {
  const cv::Mat& log_odds = result_.views[view].log_odds;
  cv::Mat& labels = labels_[view];
  labels.setTo(kNoLabel);
  labels.setTo(kObjectLabel, log_odds > kSure);
  labels.setTo(kSurroundingsLabel, log_odds < -kSure);
  ApplyGivenLabels(view, &labels);
}

bool Segmenter::Round(const BoundingCube& cube, int resolution) {
  OccupancyGrid grid(
      cube, resolution, {input_.box, input_.floor}, poses_, colours_, context_);
  if (!grid.KeepMainComponent(
          result_.region.center, result_.region.radius, HasNothingElse())) {
    return false;
  }
  result_.object_box = grid.ObjectBox();
  ParallelEach(context_, poses_.size(), 1, [&](size_t i) {
    SegmentedView& view = result_.views[i];
    view.others = ConsensusOfOthers(grid, i);
    cv::Mat smooth;
    cv::GaussianBlur(colours_[i], smooth, cv::Size(), 1);
    view.log_odds = smooth + EvidenceOfOthers(view.others);
    Relabel(i);
  });
  return true;
}

void Segmenter::CutView(size_t i) {
  SegmentedView& view = result_.views[i];
  view.log_odds = colours_[i] + EvidenceOfOthers(view.others);
  view.colours = colours_[i];
  view.mask.create(view.log_odds.size(), CV_8U);
  view.mask.setTo(kNoLabel);
  view.mask.setTo(kSurroundingsLabel, ExcludedByOthers(view.others));
  const cv::Mat& given = input_.views[i].labels;
  if (!given.empty()) {
    given.copyTo(view.mask, given != kNoLabel);
  }
  CutLabels(input_.views[i].image, view.log_odds, kSmoothness, &view.mask);
}

BoundingCube CubeAround(const Eigen::AlignedBox3d& box) {
  BoundingCube cube;
  cube.edge = box.sizes().maxCoeff() * (1 + 2 * kMargin);
  cube.min_corner = box.center() - Eigen::Vector3d::Constant(cube.edge / 2);
  return cube;
}

bool Segmenter::HasObjectLabels() const {
  return std::any_of(
      input_.views.begin(), input_.views.end(), [](const auto& view) {
        return !view.labels.empty() &&
               cv::countNonZero(view.labels == kObjectLabel) > 0;
      });
}

bool Segmenter::FindObject(double middle) {
  Phase phase(context_, "search for the object", kCoarseRounds + kFineRounds);
  const bool has_object_labels = HasObjectLabels();
  ParallelEach(context_, poses_.size(), 1, [&](size_t i) {
    const cv::Mat& proposal = input_.views[i].proposal;
    labels_[i] = proposal.empty() ? FirstLabels(i, middle) : proposal.clone();
    if (has_object_labels && proposal.empty()) {  // better than a guess
      labels_[i].setTo(kNoLabel, labels_[i] == kObjectLabel);
    }
    if (IsObjectOrStand(i)) {
      labels_[i].setTo(kNoLabel, labels_[i] == kSurroundingsLabel);
      labels_[i].setTo(kObjectLabel, input_.views[i].above_plate);
    }
    ApplyGivenLabels(i, &labels_[i]);
  });
  for (int round = 0; round < kCoarseRounds; ++round) {
    Learn(round > 0);
    if (!Round(result_.region.cube, kCoarseResolution)) {
      return false;
    }
    phase.Advance();
  }
  const BoundingCube cube = CubeAround(result_.object_box);
  for (int round = 0; round < kFineRounds; ++round) {
    Learn(true);
    if (!Round(cube, kFineResolution)) {
      return false;
    }
    phase.Advance();
  }
  return true;
}

size_t Segmenter::CountDoubts() const {
  std::vector<cv::Mat> masks;
  for (const SegmentedView& view : result_.views) {
    masks.push_back(view.mask);
  }
  const std::vector<ViewConfidence> judged = JudgeViews(result_, masks);
  return size_t(std::count_if(
      judged.begin(), judged.end(), [](const ViewConfidence& view) {
        return !view.doubt.empty();
      }));
}

Segmentation Segmenter::Run() {
  ParallelEach(context_, poses_.size(), 1, [&](size_t i) {
    features_[i] = PixelFeatures(input_.views[i].image);
  });
  const bool is_guessed = std::any_of(
      input_.views.begin(), input_.views.end(), [](const auto& view) {
        return view.proposal.empty();
      });
  std::optional<Segmentation> best;
  size_t fewest = 0;
  for (const double middle : kMiddles) {
    if (!FindObject(middle)) {
      if (!is_guessed) {
        break;  // another middle would change nothing
      }
      continue;
    }
    ParallelEach(context_, poses_.size(), 1, [&](size_t i) { CutView(i); });
    const size_t doubts = CountDoubts();
    if (!best || doubts < fewest) {
      best = std::exchange(
          result_, Segmentation{{}, result_.region, result_.object_box});
      result_.views.resize(poses_.size());
      fewest = doubts;
    }
    if (double(fewest) <= kFewDoubts * double(poses_.size()) || !is_guessed) {
      break;
    }
  }
  if (!best) {
    throw InputError(
        "the photographs: nothing that the cameras look at differs from its "
        "surroundings in all of them; `bounding_box` or strokes can help");
  }
  return *std::move(best);
}

}  // namespace

Segmentation SegmentObject(const SegmentationInput& input,
                           const Context& context) {
  return Segmenter(input, context).Run();
}

}  // namespace octacut
