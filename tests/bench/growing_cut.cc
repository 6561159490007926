#include "tests/bench/growing_cut.h"

#include <utility>

#include "tests/bench/cut_instance_file.h"
#include "tests/bench/process_usage.h"

namespace octacut {

std::vector<nlohmann::json> MeasureGrowing(
    const std::vector<std::string>& instance_paths,
    int num_threads,
    bool lean) {
  const Context context(num_threads);
  const OctahedralCutOptions options{.lean = lean};
  OctahedralCutState state;
  std::vector<nlohmann::json> results;
  size_t num_before = 0;
  for (const std::string& path : instance_paths) {
    const CutInstance instance = ReadCutInstance(path);
    const double begin = CpuSeconds();
    const OctahedralCut warm =
        SolveOctahedralCut(instance.View(), options, context, &state);
    const double middle = CpuSeconds();
    const size_t num_voxels = instance.crust.Size();
    const size_t num_added = num_voxels - std::exchange(num_before, num_voxels);
    if (path == instance_paths.front() || num_added == 0) {
      continue;
    }
    const OctahedralCut cold =
        SolveOctahedralCut(instance.View(), options, context);
    const double end = CpuSeconds();
    results.push_back({{"instance", instance.name},
                       {"solver", "growing"},
                       {"num_threads", num_threads},
                       {"lean", lean},
                       {"voxels", num_voxels},
                       {"added_voxels", num_added},
                       {"warm_cpu_seconds", middle - begin},
                       {"cold_cpu_seconds", end - middle},
                       {"equal",
                        warm.labels == cold.labels &&
                            warm.cost_fixed_point == cold.cost_fixed_point}});
  }
  return results;
}

}  // namespace octacut
