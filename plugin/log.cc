#include "plugin/log.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <spdlog/sinks/ansicolor_sink.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <ctime>

#include "colmap_io/files/lower_extension.h"
#include "core/base/check_option.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

fs::path TemporaryFolder() {
  std::error_code error;
  fs::path folder = fs::temp_directory_path(error);
  if (error) {
    throw Error(
        "--log_path: there is no folder for temporary files (TMPDIR), so a "
        "folder or file is needed here");
  }
  return folder;
}

fs::path MakeLogFilePath(const fs::path& log_path, std::string_view run_name) {
  if (LowerExtension(log_path) == ".log") {
    return log_path;
  }
  const fs::path folder = log_path.empty() ? TemporaryFolder() : log_path;
  return folder / fmt::format("octacut-{}-{:%Y%m%d-%H%M%S}-{}.log",
                              run_name,
                              fmt::localtime(std::time(nullptr)),
                              getpid());
}

spdlog::sink_ptr OpenFileSink(const fs::path& path) {
  try {
    return std::make_shared<spdlog::sinks::basic_file_sink_mt>(path.string());
  } catch (const spdlog::spdlog_ex&) {
    throw Error(fmt::format("--log_path: cannot write to {}", path.string()));
  }
}

spdlog::sink_ptr MakeConsoleSink(std::FILE* stream, bool color) {
  const auto mode =
      color ? spdlog::color_mode::automatic : spdlog::color_mode::never;
  if (stream == stdout) {
    return std::make_shared<spdlog::sinks::ansicolor_stdout_sink_mt>(mode);
  }
  return std::make_shared<spdlog::sinks::ansicolor_stderr_sink_mt>(mode);
}

spdlog::level::level_enum LeastLevel(const LogOptions& options) {
  switch (options.severity) {
    case 0:
      return options.level > 0 ? spdlog::level::debug : spdlog::level::info;
    case 1:
      return spdlog::level::warn;
    default:
      return spdlog::level::err;
  }
}

size_t TerminalWidth(std::FILE* terminal) {
  winsize size{};
  if (ioctl(fileno(terminal), TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    return size.ws_col;
  }
  return 80;
}

}  // namespace

void LogOptions::Check() const {
  CheckOption(level >= 0, "log_level", level, "must be at least 0");
  CheckOption(severity >= 0 && severity <= 2,
              "log_severity",
              severity,
              "must be 0, 1 or 2");
}

Log::Log(const LogOptions& options, std::string_view run_name) {
  options.Check();
  const bool is_file_too =
      (options.to_stderr && options.target == LogTarget::kFile) ||
      (!options.path.empty() && options.target == LogTarget::kStderr);
  const LogTarget target =
      is_file_too ? LogTarget::kStderrAndFile : options.target;
  if (target != LogTarget::kFile) {
    std::FILE* const stream = target == LogTarget::kStdout ? stdout : stderr;
    console_ = std::make_unique<spdlog::logger>(
        "console", MakeConsoleSink(stream, options.color));
    console_->set_pattern("%^%v%$");
    console_->set_level(LeastLevel(options));
    if (options.severity == 0 && isatty(fileno(stream))) {
      terminal_ = stream;
    }
  }
  if (target == LogTarget::kFile || target == LogTarget::kStderrAndFile) {
    file_ = std::make_unique<spdlog::logger>(
        "file", OpenFileSink(MakeLogFilePath(options.path, run_name)));
    file_->set_pattern("%Y-%m-%d %H:%M:%S.%e %v");
    file_->set_level(LeastLevel(options));
    file_->flush_on(spdlog::level::debug);
  }
}

Log::Log(spdlog::sink_ptr console, spdlog::sink_ptr file, std::FILE* terminal)
    : terminal_(terminal) {
  if (console != nullptr) {
    console_ = std::make_unique<spdlog::logger>("console", std::move(console));
    console_->set_pattern("%v");
  }
  if (file != nullptr) {
    file_ = std::make_unique<spdlog::logger>("file", std::move(file));
    file_->set_pattern("%v");
  }
}

void Log::Write(spdlog::level::level_enum level, const std::string& message) {
  SetStatus("");
  if (console_ != nullptr) {
    console_->log(level, message);
    console_->flush();
  }
  if (file_ != nullptr) {
    file_->log(level, message);
  }
}

void Log::Debug(std::string_view message) {
  Write(spdlog::level::debug, std::string(message));
}

void Log::Info(std::string_view message) {
  Write(spdlog::level::info, std::string(message));
}

void Log::Warn(std::string_view message) {
  Write(spdlog::level::warn, fmt::format("WARNING: {}", message));
}

void Log::ErrorToFile(std::string_view message) {
  SetStatus("");
  if (file_ != nullptr) {
    file_->error("ERROR: {}", message);
  }
}

void Log::Progress(std::string_view message) {
  if (file_ != nullptr) {
    file_->info(message);
  }
  if (console_ != nullptr && terminal_ == nullptr) {
    console_->info(message);
    console_->flush();
  }
}

void Log::SetStatus(std::string_view status) {
  if (terminal_ == nullptr || (status.empty() && !status_shown_)) {
    return;
  }
  // One column stays free, so that no terminal wraps the line.
  const std::string line(status.substr(0, TerminalWidth(terminal_) - 1));
  std::fprintf(terminal_, "\r\033[K%s", line.c_str());
  std::fflush(terminal_);
  status_shown_ = !line.empty();
}

}  // namespace octacut
