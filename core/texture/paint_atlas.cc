#include "core/texture/paint_atlas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/base/parallel.h"
#include "core/texture/fill_gaps.h"
#include "core/texture/pixel_sampler.h"
#include "core/texture/texel_colors.h"
#include "core/texture/triangle_raster.h"

namespace octacut {
namespace {

constexpr size_t kPaintedFacesPerChunk = 1024;
// The chosen view counts at least this much, so that a texel that no other view
// may show has a colour.
constexpr float kLeastOwnWeight = 1e-3f;
// What one view adds to one triangle.
struct ViewOnFace {
  bool is_own;
  Eigen::Vector3f weights;      // at the corners
  Eigen::Vector3f support;      // of its samples, at the corners
  Eigen::Matrix3f corrections;  // a column per corner
};

class PagePainter {
 public:
  PagePainter(const PaintInput& input,
              const Photographs& photographs,
              const Context& context,
              uint32_t page)
      : input_(input),
        photographs_(photographs),
        context_(context),
        map_(MapTexels(input.layout, page, context)),
        colors_(map_.size()),
        // Photographs are reduced by means of so many samples along a side.
        num_samples_(std::max(1, int(std::ceil(0.8 / input.texel_scale)))) {
    faces_of_view_.resize(photographs.poses.size());
    for (uint32_t c = 0; c < input.layout.charts.charts.size(); ++c) {
      if (input.layout.packed.places[c].page == page) {
        AddChart(input.layout.charts.charts[c]);
      }
    }
  }

  void Paint(Phase* phase, SeamPoints* seams) {
    const size_t num_views = photographs_.poses.size();
    const size_t batch = std::clamp(
        photographs_.max_held, size_t{1}, size_t(context_.NumThreads()));
    for (size_t first = 0; first < num_views; first += batch) {
      const size_t count = std::min(batch, num_views - first);
      std::vector<Photograph> loaded(count);
      ParallelEach(context_, count, 1, [&](size_t i) {
        if (!faces_of_view_[first + i].empty()) {
          loaded[i] = photographs_.load(first + i);
        }
      });
      for (size_t i = 0; i < count; ++i) {
        if (!loaded[i].image.empty()) {
          PaintView(uint32_t(first + i), loaded[i].image);
          seams->Sample(uint32_t(first + i),
                        photographs_.poses[first + i],
                        loaded[i].image);
        }
        phase->Advance();
      }
    }
    PaintUnseen();
  }

  TexturePage Finish(PaintedPages* counts) const {
    cv::Mat color(map_.size(), CV_8UC3, cv::Scalar::all(0));
    cv::Mat known(map_.size(), CV_8UC1, cv::Scalar(0));
    const bool is_median = input_.blending == ViewBlending::kMedian;
    const float noise = colors_.Noise();
    for (int y = 0; y < map_.rows; ++y) {
      for (int x = 0; x < map_.cols; ++x) {
        const bool is_inside = map_.at<int>(y, x) > 0;
        cv::Vec3b* const pixel = &color.at<cv::Vec3b>(y, x);
        // What no view shows has a mean alone.
        const bool is_known = (is_median && colors_.Median(x, y, pixel)) ||
                              colors_.Mean(x, y, noise, pixel);
        known.at<uint8_t>(y, x) = is_known ? 255 : 0;
        counts->num_texels += is_inside;
        counts->num_unfilled += is_inside && !is_known;
      }
    }
    FillGaps(known, &color);
    return {color, {}};
  }

 private:
  void AddChart(const Chart& chart) {
    for (const uint32_t f : chart.faces) {
      if (chart.view == kNoView) {
        unseen_.push_back(f);
        continue;
      }
      std::vector<uint32_t> views = {chart.view};
      for (const uint32_t v : input_.mesh.triangles[f]) {
        for (const auto* all : {&input_.fading, &input_.all_views}) {
          for (const VertexView& entry : all->Of(v)) {
            if (entry.weight > 0) {
              views.push_back(entry.view);
            }
          }
        }
      }
      std::sort(views.begin(), views.end());
      views.erase(std::unique(views.begin(), views.end()), views.end());
      for (const uint32_t view : views) {
        faces_of_view_[view].push_back(f);
      }
    }
  }

  ViewOnFace Lookup(uint32_t view, uint32_t face) const {
    const Charts& charts = input_.layout.charts;
    ViewOnFace result;
    result.is_own = charts.charts[charts.chart_of_face[face]].view == view;
    result.weights.setZero();
    result.support.setZero();
    result.corrections.setZero();
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    int count = 0;
    std::array<bool, 3> has = {false, false, false};
    for (int k = 0; k < 3; ++k) {
      const uint32_t vertex = input_.mesh.triangles[face][size_t(k)];
      const int64_t sample = input_.all_views.Find(vertex, view);
      if (sample >= 0) {
        result.support[k] = input_.all_views.entries[size_t(sample)].weight;
      }
      const int64_t entry = input_.fading.Find(vertex, view);
      if (entry >= 0) {
        has[size_t(k)] = true;
        result.weights[k] = input_.fading.entries[size_t(entry)].weight;
        result.corrections.col(k) = input_.corrections[size_t(entry)];
        sum += input_.corrections[size_t(entry)];
        ++count;
      }
    }
    // Where a view fades out, its correction goes on.
    for (int k = 0; k < 3; ++k) {
      if (!has[size_t(k)] && count > 0) {
        result.corrections.col(k) = sum / float(count);
      }
    }
    return result;
  }

  void PaintView(uint32_t view, const cv::Mat& image) {
    const std::vector<uint32_t>& faces = faces_of_view_[view];
    ParallelEach(context_, faces.size(), kPaintedFacesPerChunk, [&](size_t i) {
      PaintFace(view, faces[i], image);
    });
  }

  void PaintFace(uint32_t view, uint32_t face, const cv::Mat& image) {
    const auto texels = input_.layout.TexelsOf(face);
    const ViewOnFace on_face = Lookup(view, face);
    const bool is_median = input_.blending == ViewBlending::kMedian;
    const PhotographPose& pose = photographs_.poses[view];
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) {
      corners.col(k) =
          pose.cam_from_world *
          input_.mesh.positions[input_.mesh.triangles[face][size_t(k)]];
    }
    ForTexelsOf(map_, face, texels, [&](int x, int y) {
      Eigen::Vector3f color = Eigen::Vector3f::Zero();
      for (int j = 0; j < num_samples_; ++j) {
        for (int i = 0; i < num_samples_; ++i) {
          const Eigen::Vector3d weights = BoundedCornerWeights(
              texels,
              {x + (i + 0.5) / num_samples_, y + (j + 0.5) / num_samples_});
          const Eigen::Vector2d pixel = pose.camera.Project(corners * weights);
          color += SamplePixels(image, pixel.x(), pixel.y());
        }
      }
      color /= float(num_samples_ * num_samples_);
      const Eigen::Vector3f inside =
          BoundedCornerWeights(texels, {x + 0.5, y + 0.5})
              .cast<float>()
              .cwiseMax(0);
      const Eigen::Vector3f weights = inside / inside.sum();
      float weight = on_face.weights.dot(weights);
      if (on_face.is_own) {
        weight = std::max(weight, kLeastOwnWeight);
      }
      if (weight > 0) {
        colors_.Add(x, y, color + on_face.corrections * weights, weight);
      }
      float support = on_face.support.dot(weights);
      if (is_median && on_face.is_own) {
        support = std::max(support, kLeastOwnWeight);
      }
      // To the mean, the chosen view is no other view.
      if (support > 0 && (is_median || !on_face.is_own)) {
        colors_.AddSample(
            x, y, color.cwiseQuotient(input_.gains[view]), support);
      }
    });
  }

  void PaintUnseen() {
    for (const uint32_t f : unseen_) {
      const auto texels = input_.layout.TexelsOf(f);
      const auto& corners = input_.mesh.triangles[f];
      ForTexelsOf(map_, f, texels, [&](int x, int y) {
        const Eigen::Vector3f weights =
            BoundedCornerWeights(texels, {x + 0.5, y + 0.5}).cast<float>();
        colors_.Add(x,
                    y,
                    weights[0] * input_.fill[corners[0]] +
                        weights[1] * input_.fill[corners[1]] +
                        weights[2] * input_.fill[corners[2]],
                    1);
      });
    }
  }

  const PaintInput& input_;
  const Photographs& photographs_;
  const Context& context_;
  const cv::Mat map_;
  TexelColors colors_;
  const int num_samples_;
  std::vector<std::vector<uint32_t>> faces_of_view_;
  std::vector<uint32_t> unseen_;
};

}  // namespace

PaintedPages PaintAtlas(const PaintInput& input,
                        const Photographs& photographs,
                        const Context& context,
                        SeamPoints* seams) {
  PaintedPages result;
  const size_t num_pages = input.layout.packed.pages.size();
  Phase phase(context, "painting", num_pages * photographs.poses.size());
  for (uint32_t page = 0; page < num_pages; ++page) {
    PagePainter painter(input, photographs, context, page);
    painter.Paint(&phase, seams);
    result.pages.push_back(painter.Finish(&result));
  }
  return result;
}

}  // namespace octacut
