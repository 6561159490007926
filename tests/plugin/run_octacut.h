// Runs the built executable, or the one that the environment variable
// OCTACUT_EXECUTABLE names (an installed one), as a user would.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {

struct ProgramResult {
  int exit_code = -1;  // 128 + signal when a signal ended it
  std::string out;
  std::string err;
};

// The path of the executable under test.
std::string ExecutablePath();

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
