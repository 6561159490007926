#include "colmap_io/images/dense_map_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <opencv2/core.hpp>
#include <string>

#include "colmap_io/files/read_file.h"
#include "tests/colmap_io/files/temporary_folder.h"
#include "tests/colmap_io/images/read_dense_map.h"

namespace octacut {
namespace {

TEST(DenseMapFile, LaidOutAsColmapHasIt) {
  const TemporaryFolder folder;
  cv::Mat map(2, 3, CV_32FC3);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      map.at<cv::Vec3f>(y, x) =
          cv::Vec3f(float(10 * y + x), float(100 + 10 * y + x), -1);
    }
  }
  WriteDenseMap(folder / "n.bin", map);
  const std::string bytes = ReadFile(folder / "n.bin");
  ASSERT_EQ(bytes.substr(0, 6), "3&2&3&");
  ASSERT_EQ(bytes.size(), 6 + 18 * sizeof(float));
  // x runs fastest, then y, then the channel.
  const auto value = [&](size_t i) {
    float v;
    std::memcpy(&v, bytes.data() + 6 + i * sizeof(float), sizeof(v));
    return v;
  };
  EXPECT_EQ(value(1), 1);
  EXPECT_EQ(value(3), 10);
  EXPECT_EQ(value(6), 100);
  EXPECT_EQ(value(17), -1);
  const cv::Mat back = ReadDenseMap(folder / "n.bin");
  EXPECT_EQ(cv::norm(back, map, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace octacut
