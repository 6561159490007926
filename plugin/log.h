// Where messages of a run go: terminal and log file, as COLMAP's --log_*
// options say. An object of the run; no global logger is touched.
#pragma once

#include <spdlog/logger.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace octacut {

enum class LogTarget { kStderr, kStdout, kFile, kStderrAndFile };

struct LogOptions {
  LogTarget target = LogTarget::kStderr;
  // COLMAP 3.8's way to ask for stderr in addition to a file.
  bool to_stderr = false;
  // Folder of the log file, made if missing; empty: the system's folder for
  // temporary files. A path that ends in ".log" is the file itself.
  std::filesystem::path path;
  // 0: what happened; 1 and more: also details for developers.
  int level = 0;
  // Least severity shown: 0 information, 1 warnings, 2 errors.
  int severity = 0;
  bool color = true;  // on a terminal

  // Throws OptionError.
  void Check() const;
};

class Log {
 public:
  // Opens the log file when the target has one. Throws Error when it cannot
  // be opened. `run_name` becomes part of the file's name.
  Log(const LogOptions& options, std::string_view run_name);

  // For tests: sinks (may be null) and the terminal, null for none.
  Log(spdlog::sink_ptr console, spdlog::sink_ptr file, std::FILE* terminal);

  void Debug(std::string_view message);
  void Info(std::string_view message);
  void Warn(std::string_view message);
  // To the log file only: an error is printed on stderr by the program
  // itself, wherever messages go.
  void ErrorToFile(std::string_view message);

  // How far a phase is: to the file, and to the console unless it is a
  // terminal, which shows that by its status.
  void Progress(std::string_view message);

  // A line of the terminal that the next message or status replaces; nothing
  // without a terminal. An empty one clears it.
  void SetStatus(std::string_view status);
  bool HasTerminal() const { return terminal_ != nullptr; }

 private:
  void Write(spdlog::level::level_enum level, const std::string& message);

  std::unique_ptr<spdlog::logger> console_;
  std::unique_ptr<spdlog::logger> file_;
  std::FILE* terminal_ = nullptr;
  bool status_shown_ = false;
};

}  // namespace octacut
