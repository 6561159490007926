#include <fmt/format.h>

#include <algorithm>

#include "colmap_io/model/read_sparse_model.h"
#include "colmap_io/model/sparse_values.h"
#include "colmap_io/model/text_line.h"

namespace octacut {
namespace {

// At most this many fields are on the line.
size_t CountFields(std::string_view line) {
  return size_t(std::count(line.begin(), line.end(), ' ') +
                std::count(line.begin(), line.end(), '\t')) +
         1;
}

SparseImage ReadImageLine(const TextLines& lines) {
  static constexpr const char* kFields[7] = {
      "qw", "qx", "qy", "qz", "tx", "ty", "tz"};
  TextFields fields = lines.Fields();
  SparseImage image;
  image.id = fields.Number<uint32_t>("image_id");
  double pose[7];
  for (int i = 0; i < 7; ++i) pose[i] = fields.Number<double>(kFields[i]);
  image.camera_id = fields.Number<uint32_t>("camera_id");
  // The name is the rest of the line: it may hold blanks.
  image.name = std::string(fields.Rest());
  if (image.name.empty()) {
    lines.Fail(fmt::format("image {}: its name is missing", image.id));
  }
  SetPose(pose, fmt::format("{}: image {}", lines.Where(), image.id), &image);
  return image;
}

// The line of an image's observations, x y point3D_id each, -1 = no point.
void ReadObservationsLine(const TextLines& lines, SparseImage* image) {
  TextFields fields = lines.Fields();
  if (fields.AtEnd()) return;
  image->observations.reserve(CountFields(lines.Line()) / 3);
  while (!fields.AtEnd()) {
    SparseObservation observation;
    observation.x = fields.Number<double>("an observation's x");
    observation.y = fields.Number<double>("an observation's y");
    TextFields look_ahead = fields;
    if (look_ahead.Word("point3D_id") == "-1") {
      fields = look_ahead;
    } else {
      observation.point3D_id = fields.Number<uint64_t>("point3D_id");
    }
    CheckObservation(
        observation, image->observations.size(), lines.Where(), image->id);
    image->observations.push_back(observation);
  }
}

SparsePoint ReadPointLine(const TextLines& lines) {
  TextFields fields = lines.Fields();
  SparsePoint point;
  point.id = fields.Number<uint64_t>("point3D_id");
  static constexpr const char* kAxes[3] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) point.xyz[i] = fields.Number<double>(kAxes[i]);
  static constexpr const char* kColors[3] = {"r", "g", "b"};
  for (size_t i = 0; i < 3; ++i) {
    point.rgb[i] = fields.Number<uint8_t>(kColors[i]);
  }
  point.error = fields.Number<double>("error");
  CheckPointValues(point, lines.Where());
  const size_t num_fields = CountFields(lines.Line());
  point.track.reserve(num_fields > 8 ? (num_fields - 8) / 2 : 0);
  while (!fields.AtEnd()) {
    TrackElement element;
    element.image_id = fields.Number<uint32_t>("a track's image_id");
    element.point2D_index = fields.Number<uint32_t>("a track's point2D_idx");
    point.track.push_back(element);
  }
  return point;
}

}  // namespace

std::vector<SparseCamera> ReadCamerasText(std::istream& stream,
                                          const std::string& name) {
  TextLines lines(stream, name);
  std::vector<SparseCamera> cameras;
  while (lines.NextContent()) {
    TextFields fields = lines.Fields();
    SparseCamera camera;
    camera.id = fields.Number<uint32_t>("camera_id");
    camera.model_id =
        RequireCameraModel(
            fields.Word("model"),
            fmt::format("{}: camera {}", lines.Where(), camera.id))
            .id;
    camera.width = fields.Number<uint64_t>("width");
    camera.height = fields.Number<uint64_t>("height");
    while (!fields.AtEnd()) {
      camera.params.push_back(fields.Number<double>("a parameter"));
    }
    CheckCamera(camera, lines.Where());
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

std::vector<SparseImage> ReadImagesText(std::istream& stream,
                                        const std::string& name) {
  TextLines lines(stream, name);
  std::vector<SparseImage> images;
  while (lines.NextContent()) {
    images.push_back(ReadImageLine(lines));
    // The second line may be empty; the very last one is often missing.
    if (!lines.Next()) break;
    ReadObservationsLine(lines, &images.back());
  }
  return images;
}

std::vector<SparsePoint> ReadPointsText(std::istream& stream,
                                        const std::string& name) {
  TextLines lines(stream, name);
  std::vector<SparsePoint> points;
  while (lines.NextContent()) points.push_back(ReadPointLine(lines));
  return points;
}

}  // namespace octacut
