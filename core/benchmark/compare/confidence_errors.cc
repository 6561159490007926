#include "core/benchmark/compare/confidence_errors.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>

namespace octacut {
namespace {

struct Judged {
  double confidence;
  double distance;
};

// Linear over the triangle.
double ConfidenceAt(const IndexedMesh& mesh, const SurfaceSample& sample) {
  const std::array<uint32_t, 3>& corners = mesh.triangles[sample.triangle];
  const Eigen::Vector3d& a = mesh.positions[corners[0]];
  const Eigen::Vector3d& b = mesh.positions[corners[1]];
  const Eigen::Vector3d& c = mesh.positions[corners[2]];
  const Eigen::Vector3d& p = sample.point;
  const Eigen::Vector3d weights((b - p).cross(c - p).norm(),
                                (c - p).cross(a - p).norm(),
                                (a - p).cross(b - p).norm());
  const Eigen::Vector3d values(mesh.confidence[corners[0]],
                               mesh.confidence[corners[1]],
                               mesh.confidence[corners[2]]);
  const double sum = weights.sum();
  return sum > 0 ? weights.dot(values) / sum : values.mean();
}

// The mean error of the first tenth of `sorted`.
double MeanOfFirstTenth(const std::vector<Judged>& sorted) {
  const size_t count = std::max<size_t>(1, sorted.size() / 10);
  double sum = 0;
  for (size_t i = 0; i < count; ++i) {
    sum += sorted[i].distance;
  }
  return sum / double(count);
}

// Gives those of the same confidence their mean distance.
void LevelTies(std::vector<Judged>* sorted) {
  for (size_t begin = 0, end = 0; begin < sorted->size(); begin = end) {
    double sum = 0;
    for (end = begin; end < sorted->size() &&
                      (*sorted)[end].confidence == (*sorted)[begin].confidence;
         ++end) {
      sum += (*sorted)[end].distance;
    }
    for (size_t i = begin; i < end; ++i) {
      (*sorted)[i].distance = sum / double(end - begin);
    }
  }
}

}  // namespace

ConfidenceErrors MeasureConfidenceErrors(
    const IndexedMesh& mesh,
    const std::vector<SurfaceSample>& samples,
    const std::vector<double>& distances) {
  std::vector<Judged> judged;
  for (size_t i = 0; i < samples.size(); ++i) {
    if (!std::isnan(distances[i])) {
      judged.push_back({ConfidenceAt(mesh, samples[i]), distances[i]});
    }
  }
  ConfidenceErrors errors;
  if (judged.empty()) {
    return errors;
  }
  std::stable_sort(
      judged.begin(), judged.end(), [](const Judged& a, const Judged& b) {
        return a.confidence < b.confidence;
      });
  LevelTies(&judged);
  errors.least_confident = MeanOfFirstTenth(judged);
  std::reverse(judged.begin(), judged.end());
  errors.most_confident = MeanOfFirstTenth(judged);
  return errors;
}

}  // namespace octacut
