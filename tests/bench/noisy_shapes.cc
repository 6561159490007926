#include "tests/bench/noisy_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>
#include <unordered_map>

#include "core/cut/cut_problem.h"

namespace octacut {
namespace {

constexpr double kThickness = 4;

double Sphere(const Eigen::Vector3d& p, double resolution) {
  return (p - Eigen::Vector3d::Constant(resolution / 2 + 0.3)).norm() -
         0.37 * resolution;
}

double Ellipsoid(const Eigen::Vector3d& p, double resolution) {
  const Eigen::Quaterniond turn(0.8, 0.3, 0.4, 0.33);
  const Eigen::Vector3d axes = resolution * Eigen::Vector3d(0.38, 0.27, 0.2);
  const Eigen::Vector3d q =
      turn.normalized() * (p - Eigen::Vector3d::Constant(resolution / 2));
  const double k = q.cwiseQuotient(axes).norm();
  const double gradient = q.cwiseQuotient(axes.cwiseProduct(axes)).norm();
  return gradient > 0 ? k * (k - 1) / gradient : -resolution;
}

double Torus(const Eigen::Vector3d& p, double resolution) {
  const Eigen::Quaterniond turn(0.7, 0.5, -0.2, 0.4);
  const Eigen::Vector3d q =
      turn.normalized() * (p - Eigen::Vector3d::Constant(resolution / 2));
  const double ring = std::hypot(q.x(), q.y()) - 0.27 * resolution;
  return std::hypot(ring, q.z()) - 0.13 * resolution;
}

double CpuSeconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

Eigen::Vector3d CentreOf(MortonCode code) {
  return DecodeMorton(code).cast<double>() + Eigen::Vector3d::Constant(0.5);
}

// Fills the errors from points on the surface.
void MeasureSurface(const std::vector<Eigen::Vector3d>& points,
                    const NoisyShape& shape,
                    double resolution,
                    CutMeasure* measure) {
  constexpr double kCell = 4;  // voxels that count as vicinity
  struct Cell {
    double sum = 0;
    int count = 0;
  };
  const auto key = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3i cell = (p / kCell).cast<int>();
    return EncodeMorton(cell);
  };
  std::unordered_map<MortonCode, Cell> cells;
  std::vector<double> distances;
  for (const Eigen::Vector3d& p : points) {
    const double distance = shape.distance(p, resolution);
    distances.push_back(distance);
    Cell& cell = cells[key(p)];
    cell.sum += distance;
    ++cell.count;
  }
  double square = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Cell& cell = cells[key(points[i])];
    const double deviation = distances[i] - cell.sum / cell.count;
    square += deviation * deviation;
    measure->greatest = std::max(measure->greatest, std::abs(distances[i]));
    measure->mean += std::abs(distances[i]) / double(points.size());
  }
  measure->roughness = std::sqrt(square / double(points.size()));
}

}  // namespace

const std::vector<NoisyShape>& NoisyShapes() {
  static const std::vector<NoisyShape> shapes = {
      {"sphere", Sphere}, {"ellipsoid", Ellipsoid}, {"torus", Torus}};
  return shapes;
}

CutInstance MakeNoisyInstance(const NoisyShape& shape,
                              int resolution,
                              double noise,
                              uint64_t seed) {
  CutInstance instance;
  instance.name = shape.name;
  const auto distance = [&](const Eigen::Vector3i& v) {
    return shape.distance(v.cast<double>() + Eigen::Vector3d::Constant(0.5),
                          resolution);
  };
  std::vector<MortonCode> codes;
  for (MortonCode code = 0;
       code < MortonCode(resolution) * resolution * resolution;
       ++code) {
    if (std::abs(distance(DecodeMorton(code))) < kThickness) {
      codes.push_back(code);
    }
  }
  instance.crust = VoxelGrid::FromCodes(
      std::bit_width(unsigned(resolution)) - 1, std::move(codes));
  instance.ties.assign(instance.crust.Size(), 0);
  cv::RNG random(seed);
  instance.crust.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    const Eigen::Vector3i voxel = DecodeMorton(code);
    const double d = distance(voxel);
    const double phi = std::clamp(
        0.7 * (1 - std::exp(-d * d / 3)) + random.gaussian(noise), 0.0, 1.0);
    instance.weights.push_back(float(std::pow(phi, 4) + 1e-5));
    for (int face = 0; face < kNumFaces; ++face) {
      const Eigen::Vector3i next = NeighborVoxel(voxel, face);
      if (!instance.crust.Contains(next)) {
        instance.ties[i] |=
            distance(next) < 0 ? InsideTie(face) : OutsideTie(face);
      }
    }
  });
  return instance;
}

CutMeasure CutOctahedral(const CutInstance& instance, const NoisyShape& shape) {
  CutMeasure measure;
  const double before = CpuSeconds();
  const OctahedralCut cut = SolveOctahedralCut(instance.View(), {}, Context(1));
  measure.seconds = CpuSeconds() - before;
  measure.num_nodes = cut.num_nodes;
  measure.num_edges = 12 * instance.crust.Size();
  measure.bytes =
      double(EstimateOctahedralCutBytes(instance.crust.Size(), false));
  std::vector<Eigen::Vector3d> points;
  instance.crust.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    for (int f = 0; f < kNumFaces; ++f) {
      for (int g = (f | 1) + 1; g < kNumFaces; ++g) {
        if (((cut.labels[i] >> f) & 1) != ((cut.labels[i] >> g) & 1)) {
          Eigen::Vector3d p = CentreOf(code);
          p[f / 2] += (f & 1) ? 0.25 : -0.25;
          p[g / 2] += (g & 1) ? 0.25 : -0.25;
          points.push_back(p);
        }
      }
    }
  });
  MeasureSurface(points, shape, instance.crust.Resolution(), &measure);
  return measure;
}

CutMeasure CutVoxelCentres(const CutInstance& instance,
                           const NoisyShape& shape,
                           int num_neighbors) {
  const VoxelGrid& crust = instance.crust;
  const GridGraph norm = VoxelCentreGraph(num_neighbors);
  CutMeasure measure;
  const double before = CpuSeconds();
  cv::detail::GCGraph<double> graph(
      unsigned(crust.Size()), unsigned(2 * crust.Size() * norm.edges.size()));
  for (size_t i = 0; i < crust.Size(); ++i) {
    const FaceTies ties = instance.ties[i];
    constexpr double kTied = 1e9;
    graph.addVtx();
    graph.addTermWeights(int(i),
                         (ties & kAllFaces) ? kTied : 0,
                         (ties >> kNumFaces) ? kTied : 0);
  }
  crust.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    for (const GridGraph::Edge& edge : norm.edges) {
      const VoxelGrid::Index j = crust.Find(
          Eigen::Vector3i(DecodeMorton(code) + edge.step.cast<int>()));
      if (j != VoxelGrid::kNone) {
        const double weight =
            edge.weight * 0.5 *
            (double(instance.weights[i]) + double(instance.weights[j]));
        graph.addEdges(int(i), int(j), weight, weight);
        ++measure.num_edges;
      }
    }
  });
  graph.maxFlow();
  measure.seconds = CpuSeconds() - before;
  measure.num_nodes = crust.Size();
  // A vertex of GCGraph takes 40 bytes, each of an edge's two arcs 16.
  measure.bytes =
      40.0 * double(measure.num_nodes) + 2 * 16.0 * double(measure.num_edges);
  std::vector<Eigen::Vector3d> points;
  crust.ForEach([&](VoxelGrid::Index i, MortonCode code) {
    for (int face = 1; face < kNumFaces; face += 2) {
      const VoxelGrid::Index j =
          crust.Find(NeighborVoxel(DecodeMorton(code), face));
      if (j != VoxelGrid::kNone &&
          graph.inSourceSegment(int(i)) != graph.inSourceSegment(int(j))) {
        Eigen::Vector3d p = CentreOf(code);
        p[face / 2] += 0.5;
        points.push_back(p);
      }
    }
  });
  MeasureSurface(points, shape, crust.Resolution(), &measure);
  return measure;
}

}  // namespace octacut
