// Measures the cut engine against solvers one could link, on synthetic or
// stored instances, and prints one JSON object a run.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/cut/cut_problem.h"
#include "tests/bench/boost_cut.h"
#include "tests/bench/cut_instance_file.h"
#include "tests/bench/cut_instances.h"
#include "tests/bench/growing_cut.h"
#include "tests/bench/opencv_cut.h"
#include "tests/bench/process_usage.h"
#include "tests/bench/task_times.h"

namespace octacut {
namespace {

OctahedralCut Solve(const std::string& solver,
                    const OctahedralCutProblem& problem,
                    bool lean,
                    const Context& context) {
  if (solver == "octacut") {
    return SolveOctahedralCut(problem, {.lean = lean}, context);
  }
  const std::vector<FaceTies> ties =
      MergeFaceTies(problem, VoxelWalk(*problem.crust, Context(1)), context);
  if (solver != "boost" && solver != "opencv") {
    throw OptionError("solver " + solver + " is not known");
  }
  OctahedralCut cut = solver == "boost" ? SolveWithBoost(problem, ties)
                                        : SolveWithOpenCv(problem, ties);
  cut.num_cut_voxels =
      size_t(std::count_if(cut.labels.begin(), cut.labels.end(), IsCut));
  return cut;
}

nlohmann::json Measure(const std::string& solver,
                       const CutInstance& instance,
                       int num_threads,
                       bool lean,
                       const std::string& labels_path) {
  const OctahedralCutProblem problem = instance.View();
  const Context context(num_threads);
  // Code is paged in first, so that what grows later is data.
  const CutInstance small = MakeCutInstance("shell", 16);
  Solve(solver, small.View(), lean, context);
  const double base = ResidentBytes("VmRSS");
  const double cpu_before = CpuSeconds();
  const auto wall_before = std::chrono::steady_clock::now();
  const OctahedralCut cut = Solve(solver, problem, lean, context);
  const double cpu = CpuSeconds() - cpu_before;
  const std::chrono::duration<double> wall =
      std::chrono::steady_clock::now() - wall_before;
  const double peak = ResidentBytes("VmHWM") - base;
  const VoxelWalk walk(*problem.crust, Context(1));
  const int64_t cost = LabellingCost(problem,
                                     walk,
                                     MergeFaceTies(problem, walk, context),
                                     cut.labels,
                                     {},
                                     context);
  if (!labels_path.empty()) {
    WriteCutLabels(cut.labels, labels_path);
  }
  const double voxels = double(instance.crust.Size());
  uint64_t hash = 0xcbf29ce484222325ull;
  for (const FaceLabels labels : cut.labels) {
    hash = (hash ^ labels) * 0x100000001b3ull;
  }
  return {{"instance", instance.name},
          {"solver", lean ? solver + " lean" : solver},
          {"num_threads", context.NumThreads()},
          {"voxels", instance.crust.Size()},
          {"nodes", cut.num_nodes},
          {"flow", cut.cost_fixed_point},
          {"cost", cost},
          {"closed", cost == cut.cost_fixed_point},
          {"cut_voxels", cut.num_cut_voxels},
          {"labels_hash", hash},
          {"cpu_seconds", cpu},
          {"wall_seconds", wall.count()},
          {"cpu_seconds_per_mvoxel", cpu / voxels * 1e6},
          {"bytes_per_voxel",
           (peak + double(instance.crust.MemoryBytes())) / voxels}};
}

// Times the tasks of a search on one thread, and tells by how much more cores
// would be faster: the search alone, and all when what is not the search gains
// nothing.
nlohmann::json MeasureTasks(const CutInstance& instance) {
  const OctahedralCutProblem problem = instance.View();
  const Context context(1);
  const double cpu_before = CpuSeconds();
  CheckCutValues(problem, context);
  const VoxelWalk walk(*problem.crust, context);
  std::vector<FaceTies> ties = MergeFaceTies(problem, walk, context);
  SearchPlan plan = PlanSearch(ties, context);
  TaskTimes tasks;
  plan.observer = tasks.Observer();
  const OctahedralCut cut = SolveImplicitly(problem, walk, ties, plan, context);
  LabellingCost(problem, walk, ties, cut.labels, {}, context);
  const double total = CpuSeconds() - cpu_before;
  const double rest = total - tasks.Total();
  nlohmann::json json = {{"instance", instance.name},
                         {"solver", "tasks"},
                         {"voxels", instance.crust.Size()},
                         {"cpu_seconds", total},
                         {"search_seconds", tasks.Total()}};
  for (const int cores : {2, 4, 8, 16}) {
    const double makespan = tasks.Makespan(cores);
    json["search_gain"][std::to_string(cores)] = tasks.Total() / makespan;
    json["gain"][std::to_string(cores)] = total / (rest + makespan);
    json["gain_if_rest_scales"][std::to_string(cores)] =
        total / (rest / cores + makespan);
  }
  return json;
}

// A process of its own for each run, so that peaks do not mix.
void MeasureInChild(const std::string& solver,
                    const CutInstance& instance,
                    int num_threads,
                    bool lean,
                    const std::string& labels_path) {
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    try {
      const nlohmann::json result =
          solver == "tasks"
              ? MeasureTasks(instance)
              : Measure(solver, instance, num_threads, lean, labels_path);
      std::cout << result.dump() << std::endl;
    } catch (const std::exception& error) {
      std::cerr << error.what() << std::endl;
      _exit(1);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (status != 0) {
    throw Error(solver + " failed on " + instance.name);
  }
}

constexpr char kUsage[] =
    "octacut_cut_bench [--instance FILE ...] [--kind shell hard level0 "
    "evidence]\n"
    "  [--resolution 128] [--solvers octacut boost opencv tasks]\n"
    "  [--num_threads 1] [--repetitions 1] [--lean 0] [--labels OUT]\n"
    "  [--output_instance OUT]\n"
    "octacut_cut_bench --growing FILE FILE ...\n"
    "  one crust as it grows: each cut from the state of the last";

using Arguments = std::map<std::string, std::vector<std::string>>;

// Options with any number of values.
Arguments ParseArguments(int argc, char** argv) {
  Arguments arguments = {{"--instance", {}},
                         {"--growing", {}},
                         {"--kind", {}},
                         {"--resolution", {}},
                         {"--solvers", {}},
                         {"--num_threads", {}},
                         {"--repetitions", {}},
                         {"--lean", {}},
                         {"--labels", {}},
                         {"--output_instance", {}}};
  std::vector<std::string>* values = nullptr;
  for (int k = 1; k < argc; ++k) {
    const auto option = arguments.find(argv[k]);
    if (option != arguments.end()) {
      values = &option->second;
    } else if (values != nullptr && argv[k][0] != '-') {
      values->push_back(argv[k]);
    } else {
      throw OptionError(std::string(argv[k]) + ": not known\n" + kUsage);
    }
  }
  return arguments;
}

int Main(int argc, char** argv) {
  Arguments arguments = ParseArguments(argc, argv);
  const auto value = [&](const std::string& name, const char* otherwise) {
    return arguments[name].empty() ? std::string(otherwise)
                                   : arguments[name].front();
  };
  const std::string labels_path = value("--labels", "");
  const std::string output_path = value("--output_instance", "");
  const int resolution = std::stoi(value("--resolution", "128"));
  const int num_threads = std::stoi(value("--num_threads", "1"));
  const bool lean = value("--lean", "0") != "0";
  const int repetitions = std::stoi(value("--repetitions", "1"));
  std::vector<std::string> solvers = arguments["--solvers"];
  if (solvers.empty()) {
    solvers = {"octacut"};
  }
  const auto run = [&](const CutInstance& instance) {
    if (!output_path.empty()) {
      WriteCutInstance(instance, output_path);
    }
    for (int k = 0; k < repetitions; ++k) {
      for (const std::string& solver : solvers) {
        MeasureInChild(solver, instance, num_threads, lean, labels_path);
      }
    }
  };
  for (const nlohmann::json& result :
       MeasureGrowing(arguments["--growing"], num_threads, lean)) {
    std::cout << result.dump() << std::endl;
  }
  for (const std::string& path : arguments["--instance"]) {
    run(ReadCutInstance(path));
  }
  for (const std::string& kind : arguments["--kind"]) {
    run(MakeCutInstance(kind, resolution));
  }
  return 0;
}

}  // namespace
}  // namespace octacut

int main(int argc, char** argv) {
  try {
    return octacut::Main(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
