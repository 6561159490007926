// What a flow on the voxel grid keeps of each voxel.
#pragma once

#include <cstdint>
#include <utility>

#include "core/cut/octahedron.h"

namespace octacut {

// What searching reads.
struct SearchRecord {
  int32_t word[3];    // of the nodes on the low faces; see SearchForest
  uint32_t residual;  // bit a: arc a has a residual capacity;
                      // bit 24 + f: face f is blocked (tied or foreign)
};

// What is read when flow is pushed. `Flow` holds a weight and a flow of its
// magnitude: int32_t or int16_t.
template <typename Flow>
struct FlowRecord {
  Flow weight;
  Flow flow[kNumOctahedronEdges];  // > 0 along the edge

  int32_t Capacity(uint32_t arc) const {
    return weight - kOctahedron.sign[arc] * flow[kOctahedron.edge[arc]];
  }
  // Sends `amount` along an arc; returns whether that saturates it.
  bool Push(uint32_t arc, int32_t amount) {
    Flow& along = flow[kOctahedron.edge[arc]];
    along = Flow(along + kOctahedron.sign[arc] * amount);
    return kOctahedron.sign[arc] * along == weight;
  }

  // What leaves the node on a face through this voxel.
  template <int kFace>
  int64_t Outflow() const {
    constexpr int kArc = 4 * kFace;
    const auto out = [this](int arc) {
      return int64_t{kOctahedron.sign[arc]} * flow[kOctahedron.edge[arc]];
    };
    return out(kArc) + out(kArc + 1) + out(kArc + 2) + out(kArc + 3);
  }

  // Sets the flow of every edge at a tied face, from the source or into the
  // sink; between two tied faces no node cares. Sets of faces. Returns whether
  // that changed any.
  bool SaturateTies(int outside, int inside) {
    bool changed = false;
    for (int arc = 0; arc < kNumOctahedronArcs; ++arc) {
      const int head = kOctahedron.head[arc];
      const int tied = outside | inside;
      if (kOctahedron.sign[arc] > 0 &&
          ((tied >> (arc / 4) | tied >> head) & 1)) {
        const int from = ((outside >> (arc / 4)) & 1) | ((inside >> head) & 1);
        const int to = ((inside >> (arc / 4)) & 1) | ((outside >> head) & 1);
        const Flow saturated = Flow((from - to) * weight);
        changed |=
            std::exchange(flow[kOctahedron.edge[arc]], saturated) != saturated;
      }
    }
    return changed;
  }
};

}  // namespace octacut
