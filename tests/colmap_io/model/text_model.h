// Sparse models as text, to read.
#pragma once

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "colmap_io/model/sparse_model.h"

namespace octacut {

// The same doubles can be read again, under any global locale.
inline std::ostringstream ModelText(const char* comment) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << "# "
       << comment << '\n';
  return text;
}

inline std::string CamerasText(const std::vector<SparseCamera>& cameras) {
  std::ostringstream text = ModelText("Camera list");
  for (const SparseCamera& camera : cameras) {
    text << camera.id << ' '
         << RequireCameraModel(camera.model_id, "cameras").name << ' '
         << camera.width << ' ' << camera.height;
    for (const double param : camera.params) {
      text << ' ' << param;
    }
    text << '\n';
  }
  return text.str();
}

inline std::string ImagesText(const std::vector<SparseImage>& images) {
  std::ostringstream text = ModelText("Image list, two lines an image");
  for (const SparseImage& image : images) {
    text << image.id << ' ' << image.rotation.w();
    for (const double value : image.rotation.vec()) {
      text << ' ' << value;
    }
    for (const double value : image.translation) {
      text << ' ' << value;
    }
    text << ' ' << image.camera_id << ' ' << image.name << '\n';
    for (const SparseObservation& observation : image.observations) {
      text << observation.x << ' ' << observation.y << ' '
           << (observation.HasPoint() ? std::to_string(observation.point3D_id)
                                      : "-1")
           << ' ';
    }
    text << '\n';
  }
  return text.str();
}

inline std::string PointsText(const std::vector<SparsePoint>& points) {
  std::ostringstream text = ModelText("3D point list");
  for (const SparsePoint& point : points) {
    text << point.id;
    for (const double value : point.xyz) {
      text << ' ' << value;
    }
    for (const int value : point.rgb) {
      text << ' ' << value;
    }
    text << ' ' << point.error;
    for (const TrackElement& element : point.track) {
      text << ' ' << element.image_id << ' ' << element.point2D_index;
    }
    text << '\n';
  }
  return text.str();
}

inline void WriteTextModel(const SparseModel& model,
                           const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "cameras.txt") << CamerasText(model.cameras);
  std::ofstream(folder / "images.txt") << ImagesText(model.images);
  std::ofstream(folder / "points3D.txt") << PointsText(model.points);
}

}  // namespace octacut
