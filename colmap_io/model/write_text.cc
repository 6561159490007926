#include <fmt/format.h>

#include <string>

#include "colmap_io/model/write_sparse_model.h"

namespace octacut {
namespace {

// fmt writes the shortest digits that read back as the same double, in the C
// locale.
class TextLine {
 public:
  explicit TextLine(std::ostream& stream) : stream_(stream) {}

  template <typename T>
  void Put(const T& value) {
    if (!buffer_.empty()) {
      buffer_.push_back(' ');
    }
    // format_to would compile all of fmt's formatting once more.
    buffer_ += fmt::format("{}", value);
  }
  void End() {
    buffer_.push_back('\n');
    stream_.write(buffer_.data(), std::streamsize(buffer_.size()));
    buffer_.clear();
  }

 private:
  std::ostream& stream_;
  std::string buffer_;
};

double Mean(size_t sum, size_t count) {
  return count > 0 ? double(sum) / double(count) : 0;
}

}  // namespace

void WriteCamerasText(const std::vector<SparseCamera>& cameras,
                      std::ostream& stream) {
  stream << "# Camera list with one line of data per camera:\n"
            "#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n"
         << fmt::format("# Number of cameras: {}\n", cameras.size());
  TextLine line(stream);
  for (const SparseCamera& camera : cameras) {
    line.Put(camera.id);
    line.Put(RequireCameraModel(camera.model_id, "cameras").name);
    line.Put(camera.width);
    line.Put(camera.height);
    for (double param : camera.params) line.Put(param);
    line.End();
  }
}

void WriteImagesText(const std::vector<SparseImage>& images,
                     std::ostream& stream) {
  size_t num_observations = 0;
  for (const SparseImage& image : images) {
    for (const SparseObservation& observation : image.observations) {
      num_observations += observation.HasPoint();
    }
  }
  stream << "# Image list with two lines of data per image:\n"
            "#   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n"
            "#   POINTS2D[] as (X, Y, POINT3D_ID)\n"
         << fmt::format(
                "# Number of images: {}, mean observations per image: {}\n",
                images.size(),
                Mean(num_observations, images.size()));
  TextLine line(stream);
  for (const SparseImage& image : images) {
    line.Put(image.id);
    line.Put(image.rotation.w());
    for (double value : image.rotation.vec()) line.Put(value);
    for (double value : image.translation) line.Put(value);
    line.Put(image.camera_id);
    line.Put(image.name);
    line.End();
    for (const SparseObservation& observation : image.observations) {
      line.Put(observation.x);
      line.Put(observation.y);
      if (observation.HasPoint()) {
        line.Put(observation.point3D_id);
      } else {
        line.Put(-1);
      }
    }
    line.End();
  }
}

void WritePointsText(const std::vector<SparsePoint>& points,
                     std::ostream& stream) {
  size_t num_elements = 0;
  for (const SparsePoint& point : points) num_elements += point.track.size();
  stream << "# 3D point list with one line of data per point:\n"
            "#   POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, "
            "POINT2D_IDX)\n"
         << fmt::format("# Number of points: {}, mean track length: {}\n",
                        points.size(),
                        Mean(num_elements, points.size()));
  TextLine line(stream);
  for (const SparsePoint& point : points) {
    line.Put(point.id);
    for (double value : point.xyz) line.Put(value);
    for (uint8_t value : point.rgb) line.Put(value);
    line.Put(point.error);
    for (const TrackElement& element : point.track) {
      line.Put(element.image_id);
      line.Put(element.point2D_index);
    }
    line.End();
  }
}

}  // namespace octacut
