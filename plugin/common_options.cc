#include "plugin/common_options.h"

#include "core/base/check_option.h"

namespace octacut {

void CommonOptions::Declare(OptionManager& options) {
  options.BeginSection("Common options");
  options.Add("num_threads", &num_threads, "Threads to use; -1: all cores");
  options.Add("random_seed", &random_seed, "Seed of all pseudo-random choices");
  options.AddEnum("log_target",
                  &log.target,
                  {{"stderr", LogTarget::kStderr},
                   {"stdout", LogTarget::kStdout},
                   {"file", LogTarget::kFile},
                   {"stderr_and_file", LogTarget::kStderrAndFile}},
                  "Where messages and progress go");
  options.Add("log_to_stderr",
              &log.to_stderr,
              "1: messages go to stderr, also when --log_target is file");
  options.Add("log_path",
              &log.path,
              "Folder for log files, or a file that ends in .log; empty: the "
              "system's folder for temporary files");
  options.Add("log_level", &log.level, "1 or more: log details, too");
  options.Add("log_severity",
              &log.severity,
              "Least severity of messages: 0 information, 1 warnings, 2 "
              "errors");
  options.Add("log_color", &log.color, "1: coloured messages on a terminal");
}

void CommonOptions::Check() const {
  CheckOption(num_threads == -1 || num_threads > 0,
              "num_threads",
              num_threads,
              "must be -1 (all cores) or positive");
  log.Check();
}

}  // namespace octacut
