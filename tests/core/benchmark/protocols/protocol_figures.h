// Figures of a protocol by their names.
#pragma once

#include <stdexcept>
#include <string>

#include "core/benchmark/protocols/protocol_result.h"

namespace octacut {

inline double Figure(const ProtocolResult& result, const std::string& name) {
  for (const ProtocolFigure& figure : result.figures) {
    if (figure.name == name) {
      return figure.value;
    }
  }
  throw std::out_of_range(name);
}

inline IndexedMesh Cloud(std::vector<Eigen::Vector3d> points) {
  IndexedMesh cloud;
  cloud.positions = std::move(points);
  return cloud;
}

}  // namespace octacut
