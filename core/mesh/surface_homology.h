// Which loops of a closed surface go around its handles.
//
// A spanning tree of the vertices and one of the triangles that crosses none of
// its edges leave two edges a handle (Eppstein, Dynamic generators of
// topologically embedded graphs, SODA 2003). Each of them closes a path of
// triangles; how often a loop of edges crosses these paths, modulo 2, is its
// class, and is nowhere odd for exactly those loops that cut the surface in
// two.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/vertex_corners.h"

namespace octacut {

// Half-edge 3 * t + i leads from corner i of triangle t to the next one.
class SurfaceHomology {
 public:
  // The mesh must be closed, oriented and edge-manifold; it may have several
  // components. Throws InvariantError for a half-edge without an opposite.
  SurfaceHomology(size_t num_vertices,
                  std::span<const std::array<uint32_t, 3>> triangles);

  // Twice the genus, summed over all components.
  size_t NumGenerators() const { return generators_.size(); }

  // The class of an edge, as a word in which each generator has a random
  // pattern: that of a loop is the exclusive or over its edges, 0 for every
  // loop that separates and, but for a chance of 2^-64, for no other.
  uint64_t Class(uint32_t half_edge) const;

  // One half-edge of every edge whose class is not 0, ascending. Every loop
  // that does not separate has one of them.
  std::vector<uint32_t> CrossingHalfEdges() const;

  uint32_t Opposite(uint32_t half_edge) const { return opposite_[half_edge]; }
  // The half-edges that leave each vertex.
  const VertexCorners& Leaving() const { return leaving_; }

 private:
  struct Generator {
    uint32_t half_edge;
    uint64_t word;
  };

  void FindOpposites(std::span<const std::array<uint32_t, 3>> triangles);
  std::vector<uint8_t> GrowTree(
      std::span<const std::array<uint32_t, 3>> triangles) const;
  std::vector<uint32_t> GrowCotree(const std::vector<uint8_t>& in_tree);

  VertexCorners leaving_;
  std::vector<uint32_t> opposite_;
  // Of every triangle: its half-edge towards the root, or kNone; and the sum
  // of the generators that begin in its part of the tree of triangles.
  std::vector<uint32_t> towards_root_;
  std::vector<uint64_t> words_;
  std::vector<Generator> generators_;  // by their lower half-edge, ascending
};

}  // namespace octacut
