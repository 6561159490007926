// The files of plugin/page/web, which CMake embeds (cmake/EmbedFiles.cmake).
#pragma once

#include <span>
#include <string_view>

namespace octacut {

struct PageAsset {
  std::string_view name;  // of the file
  std::string_view text;
};

// In the order in which scripts run.
std::span<const PageAsset> PageAssets();

}  // namespace octacut
