// Depth and normal maps as COLMAP reads them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <vector>

namespace octacut {

// CV_32FC1 or CV_32FC3; empty, and the test fails, where there is none.
inline cv::Mat ReadDenseMap(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  int width = 0;
  int height = 0;
  int num_channels = 0;
  char mark[3] = {};
  stream >> width >> mark[0] >> height >> mark[1] >> num_channels >> mark[2];
  for (const char separator : mark) {
    EXPECT_EQ(separator, '&') << path;
  }
  std::vector<cv::Mat> channels;
  for (int i = 0; stream && i < num_channels; ++i) {
    cv::Mat& channel = channels.emplace_back(height, width, CV_32FC1);
    stream.read(channel.ptr<char>(),
                std::streamsize(sizeof(float)) * width * height);
  }
  cv::Mat map;
  if (!stream || channels.empty()) {
    ADD_FAILURE() << path << " ends early";
  } else {
    cv::merge(channels, map);
  }
  return map;
}

}  // namespace octacut
