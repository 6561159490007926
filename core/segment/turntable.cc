#include "core/segment/turntable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/segment/colour_contrast.h"
#include "core/segment/label_cut.h"
#include "core/segment/labels.h"
#include "core/segment/pixel_features.h"
#include "core/segment/still_background.h"
#include "core/segment/still_object.h"
#include "core/segment/still_texture.h"
#include "core/segment/view_confidence.h"

namespace octacut {
namespace {

// Part of the photographs that must show what is taken for background.
constexpr float kLeastSupport = 0.15f;
// Part of the frame that must turn, and that must stand still.
constexpr double kLeastTurning = 0.002;
constexpr double kLeastStill = 0.1;
// Constants of the cut in each photograph.
constexpr float kMostOddsOfCut = 4;
constexpr float kSmoothnessOfCut = 4;
constexpr float kUnreliable = 0.25f;
constexpr double kLeastViewConfidence = 0.5;
// Log odds of a plain object where it is most of the time: what is taken for
// background is lost, and pieces of the background are found later.
constexpr float kObjectOdds = 3;
constexpr size_t kColourSamples = 6000;
// Part of what turns that is in one piece, since the plate holds it together.
constexpr double kLeastOfPlate = 0.5;

// Windows around points beside it show it as well, up to 0.3 of their size
// away.
cv::Mat CoreOf(const cv::Mat& windows, int window) {
  cv::Mat core;
  const int reach = int(std::lround(0.3 * window));
  cv::erode(windows, core, cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U));
  return core;
}

// Of its pieces; 1 where it has none.
double PartOfLargest(const cv::Mat& mask) {
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centroids;
  const int count =
      cv::connectedComponentsWithStats(mask, labels, stats, centroids);
  int largest = 0;
  int all = 0;
  for (int i = 1; i < count; ++i) {
    const int area = stats.at<int>(i, cv::CC_STAT_AREA);
    largest = std::max(largest, area);
    all += area;
  }
  return all == 0 ? 1 : double(largest) / all;
}

class TurntableSegmenter {
 public:
  TurntableSegmenter(const TurntableInput& input, const Context& context)
      : input_(input), context_(context), result_(input.images.size()) {}

  std::vector<TurntableView> Run() {
    Phase phase(context_, "search for the turning object");
    labs_ = Labs(input_.images);
    const std::vector<cv::Mat> empty_labs = Labs(input_.empty_set);
    const StillBackground of_all = FindStillBackground(labs_, context_);
    background_ =
        empty_labs.empty() ? of_all : FindStillBackground(empty_labs, context_);
    background_.tolerance = of_all.tolerance;
    RequireTurntable(of_all);
    // What hardly ever shows the background: object, and a plate with a
    // pattern. With photographs of the empty set, the plate is what differs
    // among them.
    // Half a photograph less than all of them: shares are rounded.
    const float least = empty_labs.empty()
                            ? kLeastSupport
                            : 1 - 0.5f / float(empty_labs.size());
    unreliable_ = background_.support < least;
    always_ = CoreOf(unreliable_, kStillWindow);
    mostly_ = cv::Mat::zeros(always_.size(), CV_8U);
    if (empty_labs.empty()) {
      const cv::Mat wide = background_.wide_support < kLeastSupport;
      cv::bitwise_or(unreliable_, wide, unreliable_);
      cv::bitwise_or(
          always_, CoreOf(wide, WideWindow(always_.size())), always_);
      const cv::Mat varies = WhatVaries(labs_, of_all, context_);
      cv::bitwise_or(unreliable_, varies, unreliable_);
      const StillObject still = FindStillObject(of_all, varies, always_);
      doubt_ = still.doubt;
      Learn(still);
    }
    ParallelEach(context_, labs_.size(), 1, [&](size_t i) { CutView(i); });
    DoubtPieces();
    return std::move(result_);
  }

 private:
  std::vector<cv::Mat> Labs(const std::vector<cv::Mat>& images) const {
    std::vector<cv::Mat> labs(images.size());
    ParallelEach(context_, images.size(), 1, [&](size_t i) {
      labs[i] = ToLab(images[i]);
    });
    return labs;
  }
  void RequireTurntable(const StillBackground& of_all) const;
  void CutView(size_t i);
  void DecideHidden(size_t i, cv::Mat* log_odds) const;
  void Learn(const StillObject& still);
  void FillPieces(cv::Mat* mask) const;
  void DoubtPieces();

  const TurntableInput& input_;
  const Context& context_;
  std::vector<TurntableView> result_;
  std::vector<cv::Mat> labs_;
  StillBackground background_;
  // CV_8U, 255 where object or plate hide the background in so many photographs
  // that its colour is not known.
  cv::Mat always_;
  // CV_8U, 255 where the background may be the most frequent colour of plate or
  // object.
  cv::Mat unreliable_;
  // CV_8U, 255 where a plain object hides the background most of the time; the
  // colours decide.
  cv::Mat mostly_;
  std::optional<ColourContrast> contrast_;
  std::string doubt_;
};

void TurntableSegmenter::RequireTurntable(const StillBackground& of_all) const {
  const double frame = double(of_all.support.total());
  if (cv::countNonZero(of_all.support < 0.9f) < kLeastTurning * frame) {
    throw InputError(fmt::format(
        "the photographs: all {} show the same; nothing turns in them",
        input_.images.size()));
  }
  if (cv::countNonZero(of_all.support > 0.5f) < kLeastStill * frame) {
    throw InputError(fmt::format(
        "the photographs: hardly anything stands still in all {}; mode "
        "turntable needs a camera and a background that do not move",
        input_.images.size()));
  }
}

// What a plain object looks like in all photographs, and the background.
void TurntableSegmenter::Learn(const StillObject& still) {
  if (still.sure.empty()) {
    return;
  }
  cv::bitwise_or(always_, still.sure, always_);
  mostly_ = still.mask & ~always_;
  const size_t count = input_.images.size();
  const size_t share = kColourSamples / count + 1;
  std::vector<std::vector<PixelFeature>> objects(count);
  std::vector<std::vector<PixelFeature>> backgrounds(count);
  ParallelEach(context_, count, 1, [&](size_t i) {
    const cv::Mat features = PixelFeatures(input_.images[i]);
    objects[i] = SampleFeatures(features, still.sure, share);
    backgrounds[i] = SampleFeatures(features, still.sure_background, share);
  });
  std::vector<PixelFeature> object;
  std::vector<PixelFeature> background;
  for (size_t i = 0; i < count; ++i) {
    object.insert(object.end(), objects[i].begin(), objects[i].end());
    background.insert(
        background.end(), backgrounds[i].begin(), backgrounds[i].end());
  }
  contrast_.emplace(object, background);
}

// Background where a plain object hides it in most photographs, and that is not
// connected with other background, is object: highlights and shades look like
// background as well.
void TurntableSegmenter::FillPieces(cv::Mat* mask) const {
  const cv::Mat is_hidden = mostly_ | always_ | unreliable_;
  cv::Mat labels;
  const int count = cv::connectedComponents(*mask == 0, labels);
  std::vector<uint8_t> is_known(count);
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      if (is_hidden.at<uint8_t>(y, x) == 0) {
        is_known[labels.at<int>(y, x)] = 1;
      }
    }
  }
  for (int y = 0; y < labels.rows; ++y) {
    for (int x = 0; x < labels.cols; ++x) {
      if (is_known[labels.at<int>(y, x)] == 0) {
        mask->at<uint8_t>(y, x) = kObjectLabel;
      }
    }
  }
}

// Where the object hides the background in most photographs, and where texture
// shows the background.
void TurntableSegmenter::DecideHidden(size_t i, cv::Mat* log_odds) const {
  const StillTexture texture = input_.empty_set.empty()
                                   ? FindStillTexture(labs_, i, background_)
                                   : StillTexture(labs_[i].size());
  const cv::Mat near = texture.near & (always_ | mostly_);
  cv::Mat colours = cv::Mat::zeros(log_odds->size(), CV_32F);
  if (contrast_) {
    colours =
        contrast_->LogOdds(PixelFeatures(input_.images[i]), mostly_ | near);
  }
  cv::Mat(colours + kObjectOdds).copyTo(*log_odds, mostly_);
  log_odds->setTo(kMostOddsOfCut, always_);
  colours.copyTo(*log_odds, near);  // the border is somewhere in it
  log_odds->setTo(-kMostOddsOfCut, texture.sure);
}

void TurntableSegmenter::CutView(size_t i) {
  const cv::Mat& lab = labs_[i];
  const cv::Mat distance = DistanceFromBackground(lab, background_);
  cv::Mat log_odds = kMostOddsOfCut * (distance - 1);
  cv::min(log_odds, kMostOddsOfCut, log_odds);
  cv::max(log_odds, -kMostOddsOfCut, log_odds);
  cv::Mat(log_odds * kUnreliable).copyTo(log_odds, unreliable_);
  DecideHidden(i, &log_odds);
  // Where a whole neighbourhood is background, or object, there is nothing to
  // decide.
  const cv::Mat window = cv::Mat::ones(kStillWindow, kStillWindow, CV_8U);
  cv::Mat largest;
  cv::Mat least;
  cv::dilate(log_odds, largest, window);
  cv::erode(log_odds, least, window);
  TurntableView& view = result_[i];
  view.mask = cv::Mat(lab.size(), CV_8U, cv::Scalar(kNoLabel));
  view.mask.setTo(kSurroundingsLabel, largest < 0);
  view.mask.setTo(kObjectLabel, least > 0);
  CutLabels(input_.images[i], log_odds, kSmoothnessOfCut, &view.mask);
  if (contrast_) {
    FillPieces(&view.mask);
  }
  // Specks are smaller than the window.
  cv::Mat opened;
  cv::morphologyEx(
      view.mask, opened, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  view.mask = opened;
  view.confidence = BorderContrast(view.mask, log_odds);
  if (cv::countNonZero(view.mask) == 0) {
    view.doubt = "nothing in it differs from the background";
  } else if (!doubt_.empty()) {
    view.doubt = doubt_;
  } else if (view.confidence < kLeastViewConfidence) {
    view.doubt = fmt::format(
        "object and background look alike along {:.0f} % of the border",
        100 * (1 - view.confidence));
  }
}

// Pieces in most views are what differs on an object that is taken for
// background.
void TurntableSegmenter::DoubtPieces() {
  const auto in_pieces =
      std::count_if(result_.begin(), result_.end(), [](const auto& view) {
        return PartOfLargest(view.mask) < kLeastOfPlate;
      });
  if (2 * size_t(in_pieces) <= result_.size()) {
    return;
  }
  for (TurntableView& view : result_) {
    if (view.doubt.empty()) {
      view.doubt = fmt::format(
          "in {} of {} photographs, what differs from the background falls "
          "into pieces; object and plate may look the same from all sides",
          in_pieces,
          result_.size());
    }
  }
}

}  // namespace

std::vector<TurntableView> SegmentTurntable(const TurntableInput& input,
                                            const Context& context) {
  return TurntableSegmenter(input, context).Run();
}

}  // namespace octacut
