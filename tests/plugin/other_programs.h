// Programs of others that tests run where they are installed.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "colmap_io/files/read_file.h"
#include "tests/colmap_io/files/temporary_folder.h"

namespace octacut {

inline bool IsInstalled(const std::string& program) {
  return std::system(
             fmt::format("command -v {} >/dev/null 2>&1", program).c_str()) ==
         0;
}

// Output of both kinds; a test that runs it fails where the command does.
inline std::string RunOther(const std::string& command,
                            const TemporaryFolder& folder) {
  const std::string log = (folder / "log").string();
  // They may wait for a terminal.
  const int status = std::system(
      fmt::format("timeout 120 {} </dev/null >'{}' 2>&1", command, log)
          .c_str());
  std::string out = ReadFile(log);
  EXPECT_EQ(WEXITSTATUS(status), 0) << out;
  return out;
}

}  // namespace octacut

#define SKIP_WITHOUT(program)                                         \
  if (!IsInstalled(program)) {                                        \
    GTEST_SKIP() << (program) << " is not installed; "                \
                 << "workflows/setup.sh --with_test_tools 1 does so"; \
  }
