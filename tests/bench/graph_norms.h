// What planes and spheres cost in graphs whose nodes sit on a regular grid.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace octacut {

// The edges of a graph on a grid of voxels of edge 1, a voxel: from where,
// relative to its centre, which way, and capacities.
struct GridGraph {
  struct Edge {
    Eigen::Vector3d from;
    Eigen::Vector3d step;
    double weight;
  };
  std::string name;
  double nodes_per_voxel = 1;
  std::vector<Edge> edges;

  // Cost of a plane with unit normal n, an area of 1: every edge crosses it
  // |n . step| times.
  double PlaneCost(const Eigen::Vector3d& n) const;
  // Cost of the labelling that puts nodes inside a sphere inside, over the
  // sphere's area.
  double SphereCost(const Eigen::Vector3d& centre, double radius) const;
};

// Voxel centres with 6, 18 or 26 neighbours, weights by the solid angle that
// each direction stands for [Boykov & Kolmogorov, ICCV 2003].
GridGraph VoxelCentreGraph(int num_neighbors);

// Face centres, twelve edges per voxel; `opposite` the weight of three more
// between opposite faces, relative to theirs. Scaled to cost 1 on average.
GridGraph OctahedralGraph(double opposite);

// Unit vectors that cover the sphere evenly.
std::vector<Eigen::Vector3d> EvenDirections(int count);

struct NormSpread {
  double least, greatest, deviation;  // over all orientations
};
NormSpread SpreadOf(const GridGraph& graph);

}  // namespace octacut
