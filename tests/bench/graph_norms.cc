#include "tests/bench/graph_norms.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace octacut {
namespace {

// One of each pair of opposite steps to the neighbours.
std::vector<Eigen::Vector3d> HalfNeighbors(int num_neighbors) {
  const int max_axes = num_neighbors == 6 ? 1 : num_neighbors == 18 ? 2 : 3;
  std::vector<Eigen::Vector3d> steps;
  for (int code = 14; code < 27; ++code) {
    const Eigen::Vector3i step(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
    if (step.cwiseAbs().sum() <= max_axes) {
      steps.push_back(step.cast<double>());
    }
  }
  return steps;
}

// Relative to the voxel's.
Eigen::Vector3d FaceCentre(int face) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  centre[face / 2] = (face & 1) ? 0.5 : -0.5;
  return centre;
}

}  // namespace

double GridGraph::PlaneCost(const Eigen::Vector3d& n) const {
  double cost = 0;
  for (const Edge& edge : edges) {
    cost += edge.weight * std::abs(n.dot(edge.step));
  }
  return cost;
}

double GridGraph::SphereCost(const Eigen::Vector3d& centre,
                             double radius) const {
  const int extent = int(radius) + 3;
  const auto is_inside = [&](const Eigen::Vector3d& p) {
    return (p - centre).squaredNorm() < radius * radius;
  };
  double cost = 0;
  for (int z = -extent; z <= extent; ++z) {
    for (int y = -extent; y <= extent; ++y) {
      for (int x = -extent; x <= extent; ++x) {
        const Eigen::Vector3d voxel(x, y, z);
        if (std::abs((voxel - centre).norm() - radius) > 3) {
          continue;
        }
        for (const Edge& edge : edges) {
          const Eigen::Vector3d from = voxel + edge.from;
          if (is_inside(from) != is_inside(from + edge.step)) {
            cost += edge.weight;
          }
        }
      }
    }
  }
  return cost / (4 * std::numbers::pi * radius * radius);
}

std::vector<Eigen::Vector3d> EvenDirections(int count) {
  std::vector<Eigen::Vector3d> directions;
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count;
    const double angle = k * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    directions.push_back({r * std::cos(angle), r * std::sin(angle), z});
  }
  return directions;
}

GridGraph VoxelCentreGraph(int num_neighbors) {
  const std::vector<Eigen::Vector3d> steps = HalfNeighbors(num_neighbors);
  // Share of the directions that are nearest to each step.
  std::vector<double> share(steps.size(), 0);
  const std::vector<Eigen::Vector3d> directions = EvenDirections(200000);
  for (const Eigen::Vector3d& direction : directions) {
    size_t nearest = 0;
    double greatest = -1;
    for (size_t k = 0; k < steps.size(); ++k) {
      const double cosine = std::abs(direction.dot(steps[k])) / steps[k].norm();
      if (cosine > greatest) {
        greatest = cosine;
        nearest = k;
      }
    }
    share[nearest] += 1.0 / double(directions.size());
  }
  GridGraph graph;
  graph.name = std::to_string(num_neighbors) + " neighbours";
  for (size_t k = 0; k < steps.size(); ++k) {
    // Cauchy-Crofton: solid angle 2 pi share, over pi |step|.
    graph.edges.push_back(
        {Eigen::Vector3d::Zero(), steps[k], 2 * share[k] / steps[k].norm()});
  }
  return graph;
}

GridGraph OctahedralGraph(double opposite) {
  GridGraph graph;
  graph.name = opposite > 0 ? "octahedral + 3" : "octahedral";
  graph.nodes_per_voxel = 3;
  for (int f = 0; f < 6; ++f) {
    for (int g = f + 1; g < 6; ++g) {
      const Eigen::Vector3d from = FaceCentre(f);
      const Eigen::Vector3d step = FaceCentre(g) - from;
      if (f / 2 != g / 2) {
        graph.edges.push_back({from, step, 1.0});
      } else if (opposite > 0) {
        graph.edges.push_back({from, step, opposite});
      }
    }
  }
  const std::vector<Eigen::Vector3d> directions = EvenDirections(20000);
  double mean = 0;
  for (const Eigen::Vector3d& direction : directions) {
    mean += graph.PlaneCost(direction) / double(directions.size());
  }
  for (GridGraph::Edge& edge : graph.edges) {
    edge.weight /= mean;
  }
  return graph;
}

NormSpread SpreadOf(const GridGraph& graph) {
  NormSpread spread = {1e9, 0, 0};
  const std::vector<Eigen::Vector3d> directions = EvenDirections(50000);
  const auto visit = [&](const Eigen::Vector3d& direction) {
    const double cost = graph.PlaneCost(direction);
    spread.least = std::min(spread.least, cost);
    spread.greatest = std::max(spread.greatest, cost);
    return cost;
  };
  double square = 0;
  for (const Eigen::Vector3d& direction : directions) {
    const double cost = visit(direction);
    square += (cost - 1) * (cost - 1);
  }
  // The extremes sit where the grid is symmetric.
  visit({1, 0, 0});
  visit(Eigen::Vector3d(1, 1, 0).normalized());
  visit(Eigen::Vector3d(1, 1, 1).normalized());
  spread.deviation = std::sqrt(square / double(directions.size()));
  return spread;
}

}  // namespace octacut
