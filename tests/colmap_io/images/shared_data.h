// Where the shared measuring data is, if it is there at all.
#pragma once

#include <cstdlib>
#include <filesystem>

namespace octacut::testing {

// $OCTACUT_SHARED_DATA, or ../shared/data beside the source tree.
inline std::filesystem::path SharedData() {
  const char* variable = std::getenv("OCTACUT_SHARED_DATA");
  return variable ? std::filesystem::path(variable)
                  : std::filesystem::path(OCTACUT_SOURCE_DIR).parent_path() /
                        "shared" / "data";
}

}  // namespace octacut::testing
