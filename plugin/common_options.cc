#include "plugin/common_options.h"

#include "core/base/context.h"

namespace octacut {

void CommonOptions::Declare(OptionManager& options, bool uses_random_seed) {
  options.BeginSection("Common options");
  options.Add(
      "num_threads", &num_threads, "Number of threads; -1 uses all cores.");
  Option& seed = options.Add(
      "random_seed", &random_seed, "Seed of all pseudo-random numbers.");
  if (!uses_random_seed) {
    seed.ForNobody();
  }
  options.AddEnum("log_target",
                  &log.target,
                  {{"stderr", LogTarget::kStderr},
                   {"stdout", LogTarget::kStdout},
                   {"file", LogTarget::kFile},
                   {"stderr_and_file", LogTarget::kStderrAndFile}},
                  "Where log messages and progress are written.");
  options.Add("log_path",
              &log.path,
              "Log file (.log), or a folder for log files. Messages go there, "
              "too, unless log_target is stdout. Default: no file; if "
              "log_target asks for one, it is in the system's temporary "
              "folder.");
  // As COLMAP 3.8 has it; log_target says more.
  options
      .Add("log_to_stderr",
           &log.to_stderr,
           "If 1, write log messages to stderr even if log_target is file.")
      .ForNobody();
  options
      .Add("log_level",
           &log.level,
           "Level of detail; 1 or more adds debug messages.")
      .ForExperts();
  options
      .Add("log_severity",
           &log.severity,
           "Minimum severity of log messages: 0 for information, 1 for "
           "warnings, 2 for errors.")
      .ForExperts();
  options
      .Add("log_color",
           &log.color,
           "If 1, colour the log messages on a terminal.")
      .ForExperts();
}

void CommonOptions::Check() const {
  Context{num_threads};  // checks it
  log.Check();
}

}  // namespace octacut
