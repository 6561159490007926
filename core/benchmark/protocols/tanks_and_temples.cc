#include "core/benchmark/protocols/tanks_and_temples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/benchmark/protocols/point_tree.h"
#include "core/benchmark/protocols/surface_points.h"

namespace octacut {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// run.py asks for 20 iterations and a tolerance of 1e-6. registration.py passes
// the 20 to Open3D as the tolerance of the root mean square, so that the
// toolbox stops as soon as the number of pairs stays the same; here both
// tolerances are 1e-6, as meant.
constexpr int kMaxIterations = 20;
constexpr double kTolerance = 1e-6;
// Below it, most of the mesh has not found its place.
constexpr double kLeastFitness = 0.5;
constexpr double kMaxPoints = 4e6;
constexpr size_t kVoxelGrain = 2048;

Points Move(const Similarity3d& transform, Points points) {
  for (Eigen::Vector3d& point : points) {
    point = transform * point;
  }
  return points;
}

Points Crop(Points points, const CropPolygon& crop, const char* which) {
  std::erase_if(points,
                [&](const Eigen::Vector3d& p) { return !crop.Contains(p); });
  if (points.empty()) {
    throw InputError(
        fmt::format("tanks_and_temples: no point of the {} is inside the crop "
                    "volume",
                    which));
  }
  return points;
}

// Every k-th point of clouds with more than kMaxPoints.
Points TakeEvenly(Points points) {
  const auto step = static_cast<size_t>(std::max(
      std::lround(static_cast<double>(points.size()) / kMaxPoints), 1L));
  if (step > 1) {
    for (size_t i = 0; i * step < points.size(); ++i) {
      points[i] = points[i * step];
    }
    points.resize((points.size() + step - 1) / step);
  }
  return points;
}

// The similarity that minimises the squared distances of the pairs (Umeyama
// 1991).
Similarity3d FitPairs(const Points& from, const Points& to) {
  const auto count = static_cast<Eigen::Index>(from.size());
  Eigen::Matrix3Xd source(3, count);
  Eigen::Matrix3Xd target(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    source.col(i) = from[static_cast<size_t>(i)];
    target.col(i) = to[static_cast<size_t>(i)];
  }
  const Eigen::Matrix4d matrix = Eigen::umeyama(source, target, true);
  Similarity3d fit;
  fit.scale = matrix.topLeftCorner<3, 1>().norm();
  fit.rotation = matrix.topLeftCorner<3, 3>() / fit.scale;
  fit.translation = matrix.topRightCorner<3, 1>();
  return fit;
}

struct Registration {
  Similarity3d transform;
  double fitness = -1;  // the share of the points that have a partner
  double rms = -1;      // of the distances to these partners
};

// ICP between points with scale, as Open3D's registration_icp.
Registration RunIcp(Points source,
                    const PointTree& target,
                    double max_distance,
                    const Context& context) {
  Phase phase(context, "alignment of the points", kMaxIterations);
  Registration result;
  for (int iteration = 0; iteration <= kMaxIterations; ++iteration) {
    std::vector<PointTree::Closest> closest(source.size());
    ParallelEach(context, source.size(), kVoxelGrain, [&](size_t i) {
      closest[i] = target.FindClosest(source[i]);
    });
    Points from;
    Points to;
    for (size_t i = 0; i < source.size(); ++i) {
      if (closest[i].distance < max_distance) {
        from.push_back(source[i]);
        to.push_back(target.Points()[closest[i].index]);
      }
    }
    if (from.size() < 3) {
      throw InputError(fmt::format(
          "tanks_and_temples: fewer than 3 points of the mesh are within {:g} "
          "of the reference; is the rough alignment (transform_path) right?",
          max_distance));
    }
    double sum_of_squares = 0;
    for (size_t i = 0; i < from.size(); ++i) {
      sum_of_squares += (from[i] - to[i]).squaredNorm();
    }
    const auto num_pairs = static_cast<double>(from.size());
    const double fitness = num_pairs / static_cast<double>(source.size());
    const double rms = std::sqrt(sum_of_squares / num_pairs);
    const bool has_settled = std::abs(fitness - result.fitness) < kTolerance &&
                             std::abs(rms - result.rms) < kTolerance;
    result.fitness = fitness;
    result.rms = rms;
    if (iteration == kMaxIterations || has_settled) {
      break;
    }
    const Similarity3d step = FitPairs(from, to);
    result.transform = step * result.transform;
    source = Move(step, std::move(source));
    phase.Advance();
  }
  return result;
}

double FractionBelow(const std::vector<double>& distances, double limit) {
  const auto count =
      std::count_if(distances.begin(), distances.end(), [&](double distance) {
        return distance < limit;
      });
  return static_cast<double>(count) / static_cast<double>(distances.size());
}

}  // namespace

ProtocolResult MeasureTanksAndTemples(const IndexedMesh& mesh,
                                      const IndexedMesh& reference,
                                      const CropPolygon& crop,
                                      double tau,
                                      const Context& context) {
  const Points source = PointsOfSurface(mesh, tau / 2, context.Seed(), context);
  const Points target =
      Crop(PointsOfSurface(reference, tau / 2, context.Seed() + 1, context),
           crop,
           "reference");
  const auto moved_and_cropped = [&](const Similarity3d& transform) {
    return Crop(Move(transform, source), crop, "mesh");
  };
  Similarity3d aligned;
  for (const auto& [cell, reach] :
       {std::pair(tau, 80 * tau), std::pair(tau / 2, 20 * tau)}) {
    aligned = RunIcp(AverageInCells(moved_and_cropped(aligned), cell),
                     PointTree(AverageInCells(target, cell)),
                     reach,
                     context)
                  .transform *
              aligned;
  }
  const Registration last = RunIcp(TakeEvenly(moved_and_cropped(aligned)),
                                   PointTree(TakeEvenly(target)),
                                   2 * tau,
                                   context);
  aligned = last.transform * aligned;
  if (last.fitness < kLeastFitness) {
    context.Warn(fmt::format(
        "tanks_and_temples: after the alignment, only {:.0f} % of the mesh's "
        "points are within {:g} of the reference; check the rough alignment "
        "(transform_path)",
        100 * last.fitness,
        2 * tau));
  }
  const PointTree judged(AverageInCells(moved_and_cropped(aligned), tau / 2));
  const PointTree truth(AverageInCells(target, tau / 2));
  ProtocolResult result;
  result.scores.push_back(MakeScore(
      tau,
      FractionBelow(ClosestDistances(judged.Points(), truth, context), tau),
      FractionBelow(ClosestDistances(truth.Points(), judged, context), tau)));
  result.figures = {{"inlier fraction", last.fitness, FigureKind::kFraction},
                    {"inlier RMSE", last.rms, FigureKind::kDistance},
                    {"points",
                     static_cast<double>(judged.Points().size()),
                     FigureKind::kCount},
                    {"reference points",
                     static_cast<double>(truth.Points().size()),
                     FigureKind::kCount}};
  result.reference_from_mesh = aligned;
  return result;
}

}  // namespace octacut
