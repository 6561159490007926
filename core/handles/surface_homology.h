// Which loops of a closed surface go around its handles.
//
// A spanning tree of the vertices and one of the triangles that crosses none of
// its edges leave two edges a handle (Eppstein, Dynamic generators of
// topologically embedded graphs, SODA 2003). Each of them closes a path of
// triangles; how often a loop of edges crosses these paths, modulo 2, is its
// class, and is nowhere odd for exactly those loops that cut the surface in
// two.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/context.h"
#include "core/handles/half_edges.h"

namespace octacut {

class SurfaceHomology {
 public:
  // Keeps a reference; the mesh may have several components.
  SurfaceHomology(const HalfEdges& half_edges, const Context& context);

  // Twice the genus, summed over all components.
  size_t NumGenerators() const { return generators_.size(); }

  // The class of an edge, as a word in which each generator has a random
  // pattern: that of a loop is the exclusive or over its edges, 0 for every
  // loop that separates and, but for a chance of 2^-64, for no other.
  uint64_t Class(uint32_t half_edge) const;

  // One half-edge of every edge whose class is not 0, ascending. Every loop
  // that does not separate has one of them.
  std::vector<uint32_t> CrossingHalfEdges() const;

 private:
  struct Generator {
    uint32_t half_edge;
    uint64_t word;
  };

  std::vector<uint8_t> GrowTree() const;
  std::vector<uint32_t> GrowCotree(const std::vector<uint8_t>& in_tree);

  const HalfEdges& half_edges_;
  // For each triangle its half-edge towards the root, or HalfEdges::kNone, and
  // the sum of the generators that begin in its part of the tree of triangles.
  std::vector<uint32_t> towards_root_;
  std::vector<uint64_t> words_;
  std::vector<Generator> generators_;  // by their lower half-edge, ascending
};

}  // namespace octacut
