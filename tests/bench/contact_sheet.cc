// Puts pictures of runs onto one sheet, each with its name:
//   octacut_contact_sheet OUTPUT.jpg COLUMNS WIDTH NAME PICTURE [NAME
//   PICTURE]...
// WIDTH of a picture on the sheet, pixels.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr int kTextHeight = 18;
constexpr int kMargin = 4;
// Keeps a sheet of some twenty runs below 300 kB.
constexpr int kJpegQuality = 82;

cv::Mat MakeCell(const std::string& name, const std::string& path, int width) {
  const cv::Mat picture = cv::imread(path, cv::IMREAD_COLOR);
  if (picture.empty()) {
    throw std::runtime_error(path + ": cannot be read");
  }
  const int height = std::max(
      1, int(std::lround(double(picture.rows) * width / picture.cols)));
  cv::Mat cell(height + kTextHeight, width, CV_8UC3, cv::Scalar::all(255));
  cv::resize(picture,
             cell(cv::Rect(0, kTextHeight, width, height)),
             {width, height},
             0,
             0,
             cv::INTER_AREA);
  cv::putText(cell,
              name,
              {2, kTextHeight - 5},
              cv::FONT_HERSHEY_SIMPLEX,
              0.45,
              cv::Scalar::all(0),
              1,
              cv::LINE_AA);
  return cell;
}

cv::Mat MakeSheet(const std::vector<cv::Mat>& cells,
                  size_t columns,
                  int width) {
  std::vector<int> tops = {kMargin};
  for (size_t begin = 0; begin < cells.size(); begin += columns) {
    int height = 0;
    for (size_t i = begin; i < std::min(cells.size(), begin + columns); ++i) {
      height = std::max(height, cells[i].rows);
    }
    tops.push_back(tops.back() + height + kMargin);
  }
  const int used = int(std::min(columns, cells.size()));
  cv::Mat sheet(tops.back(),
                used * (width + kMargin) + kMargin,
                CV_8UC3,
                cv::Scalar::all(255));
  for (size_t i = 0; i < cells.size(); ++i) {
    const int left = kMargin + int(i % columns) * (width + kMargin);
    cells[i].copyTo(
        sheet(cv::Rect(left, tops[i / columns], width, cells[i].rows)));
  }
  return sheet;
}

}  // namespace

int main(int argc, char** argv) {
  const int columns = argc > 2 ? std::atoi(argv[2]) : 0;
  const int width = argc > 3 ? std::atoi(argv[3]) : 0;
  if (argc < 6 || argc % 2 != 0 || columns < 1 || width < 16) {
    std::cerr << "usage: octacut_contact_sheet OUTPUT.jpg COLUMNS WIDTH "
                 "NAME PICTURE [NAME PICTURE]...\n";
    return 1;
  }
  try {
    std::vector<cv::Mat> cells;
    for (int i = 4; i < argc; i += 2) {
      cells.push_back(MakeCell(argv[i], argv[i + 1], width));
    }
    if (!cv::imwrite(argv[1],
                     MakeSheet(cells, size_t(columns), width),
                     {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})) {
      throw std::runtime_error(std::string(argv[1]) + ": cannot be written");
    }
  } catch (const std::exception& failure) {
    std::cerr << "octacut_contact_sheet: " << failure.what() << '\n';
    return 1;
  }
  return 0;
}
