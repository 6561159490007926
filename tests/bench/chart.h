// Line charts as pictures.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace octacut {

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

struct Chart {
  std::string title;
  std::vector<Curve> curves;
  // Names of positions along x.
  std::vector<std::pair<double, std::string>> ticks;
};

// Writes a PNG. Throws InputError when that fails.
void DrawChart(const Chart& chart, const std::string& path);

}  // namespace octacut
