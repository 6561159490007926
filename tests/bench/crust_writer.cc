// Runs a reconstruction and stores every cut it makes as an instance for
// octacut_cut_bench.
#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <map>

#include "colmap_io/images/load_scene.h"
#include "core/base/error.h"
#include "core/pipeline/reconstruct.h"
#include "tests/bench/cut_instance_file.h"

namespace octacut {
namespace {

constexpr char kUsage[] =
    "octacut_crust_writer --workspace_path W --output_path FOLDER\n"
    "  [--input_path MODEL] [--target_level 9] [--num_threads 1]\n"
    "Writes FOLDER/level_LL_K.oct: the K-th cut of level LL.";

void Run(const std::map<std::string, std::string>& arguments) {
  const auto value = [&](const std::string& name, const char* otherwise) {
    const auto found = arguments.find(name);
    if (found == arguments.end() && otherwise == nullptr) {
      throw OptionError(name + " is needed\n" + kUsage);
    }
    return found == arguments.end() ? std::string(otherwise) : found->second;
  };
  const std::filesystem::path folder = value("--output_path", nullptr);
  std::filesystem::create_directories(folder);
  LoadSceneOptions loading;
  loading.workspace.input_path = value("--input_path", "");
  ReconstructionOptions options;
  options.target_level = std::stoi(value("--target_level", "9"));
  std::map<int, int> num_cuts;
  options.cut.observer = [&](const OctahedralCutProblem& problem) {
    CutInstance instance;
    const int level = problem.crust->Level();
    instance.crust = *problem.crust;
    instance.weights.assign(problem.weights.begin(), problem.weights.end());
    instance.ties.assign(problem.ties.begin(), problem.ties.end());
    instance.evidence.assign(problem.evidence.begin(), problem.evidence.end());
    const std::filesystem::path path =
        folder / fmt::format("level_{:02d}_{}.oct", level, ++num_cuts[level]);
    WriteCutInstance(instance, path.string());
    std::cout << fmt::format(
                     "{}: {} voxels", path.string(), instance.crust.Size())
              << std::endl;
  };
  options.Check();
  const Context context(std::stoi(value("--num_threads", "1")));
  const LoadedScene loaded = LoadScene(value("--workspace_path", nullptr),
                                       loading,
                                       options.target_level,
                                       context);
  Reconstruct(loaded.scene, loaded.region, options, context);
}

}  // namespace
}  // namespace octacut

int main(int argc, char** argv) {
  try {
    std::map<std::string, std::string> arguments;
    for (int k = 1; k + 1 < argc; k += 2) {
      arguments[argv[k]] = argv[k + 1];
    }
    octacut::Run(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 1;
  }
}
