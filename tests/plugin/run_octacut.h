// Runs the built executable, or the one that the environment variable
// OCTACUT_EXECUTABLE names (an installed one), as a user would.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace octacut {

struct ProgramResult {
  int exit_code = -1;  // 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

// A folder of its own for each test, removed afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& Path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  // Writes a file and returns its path.
  std::filesystem::path Write(const std::string& name,
                              const std::string& text) const;

 private:
  std::filesystem::path path_;
};

// Of the executable under test.
std::string ExecutablePath();

std::string ReadFile(const std::filesystem::path& path);

// A running octacut.
class RunningOctacut {
 public:
  explicit RunningOctacut(const std::vector<std::string>& arguments);
  ~RunningOctacut();
  RunningOctacut(const RunningOctacut&) = delete;
  RunningOctacut& operator=(const RunningOctacut&) = delete;

  void Signal(int signal);
  // What it has written to stderr so far.
  std::string Err() const;
  bool HasEnded();
  ProgramResult Wait();

 private:
  TemporaryFolder folder_;
  pid_t process_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

ProgramResult RunOctacut(const std::vector<std::string>& arguments);

}  // namespace octacut
