#include "plugin/report.h"

#include <fstream>
#include <thread>

namespace octacut {

std::string OctacutVersion() { return OCTACUT_VERSION; }

uint64_t PeakMemoryBytes() {
  std::ifstream status("/proc/self/status");
  for (std::string field; status >> field;) {
    if (field == "VmHWM:") {
      uint64_t kibibytes = 0;
      status >> kibibytes;
      return kibibytes * 1024;
    }
  }
  return 0;
}

Json MakeReport(const CommandEnvironment& environment) {
  Json phases = Json::array();
  for (const PhaseTiming& timing : environment.timer.Timings()) {
    phases.push_back({{"name", timing.name},
                      {"depth", timing.depth},
                      {"seconds", timing.seconds}});
  }
  Json report;
  report["program"] = "octacut";
  report["version"] = OctacutVersion();
  report["command"] = std::string(environment.command_name);
  report["options"] = environment.options.ToJson();
  report["num_threads"] = environment.context.NumThreads();
  report["host_threads"] = std::thread::hardware_concurrency();
  report["warnings"] = environment.timer.Warnings();
  report["phases"] = std::move(phases);
  report["seconds"] = environment.timer.TotalSeconds();
  report["peak_memory_bytes"] = PeakMemoryBytes();
  return report;
}

void WriteReport(const std::filesystem::path& path, const Json& report) {
  AtomicFiles files;
  WriteReport(path, report, &files);
  files.Commit();
}

void WriteReport(const std::filesystem::path& path,
                 const Json& report,
                 AtomicFiles* files) {
  const std::string text =
      report.dump(2, ' ', false, Json::error_handler_t::replace);
  files->Write(path, [&](std::ostream& stream) { stream << text << '\n'; });
}

}  // namespace octacut
