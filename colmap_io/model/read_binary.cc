#include <fmt/format.h>

#include "colmap_io/model/binary_reader.h"
#include "colmap_io/model/read_sparse_model.h"
#include "colmap_io/model/sparse_values.h"

namespace octacut {
namespace {

// Smallest sizes of a record: a camera with two parameters (EQUIRECTANGULAR,
// to be refused by its name), an image with a name of one letter, a point
// without a track.
constexpr uint64_t kMinCameraBytes = 4 + 4 + 8 + 8 + 2 * 8;
constexpr uint64_t kMinImageBytes = 4 + 7 * 8 + 4 + 2 + 8;
constexpr uint64_t kMinPointBytes = 8 + 3 * 8 + 3 + 8 + 8;

static_assert(sizeof(SparseObservation) == 24, "read as it is in the file");
static_assert(sizeof(TrackElement) == 8, "read as it is in the file");

SparseImage ReadImage(BinaryReader& reader) {
  SparseImage image;
  image.id = reader.Read<uint32_t>("an image's id");
  const std::string where = fmt::format("image {}", image.id);
  double pose[7];  // qw qx qy qz tx ty tz
  reader.ReadBytes(pose, sizeof(pose), where + ": its pose");
  image.camera_id = reader.Read<uint32_t>(where + ": camera_id");
  image.name = reader.ReadString(where + ": name");
  SetPose(pose, fmt::format("{}: {}", reader.Name(), where), &image);
  const uint64_t count = reader.ReadCount(sizeof(SparseObservation),
                                          where + ": number of observations");
  image.observations.resize(count);
  reader.ReadBytes(image.observations.data(),
                   count * sizeof(SparseObservation),
                   where + ": observations");
  for (size_t i = 0; i < count; ++i) {
    CheckObservation(image.observations[i], i, reader.Name(), image.id);
  }
  return image;
}

SparsePoint ReadPoint(BinaryReader& reader) {
  SparsePoint point;
  point.id = reader.Read<uint64_t>("a point's id");
  reader.ReadBytes(point.xyz.data(), 3 * sizeof(double), "a point's xyz");
  reader.ReadBytes(point.rgb.data(), 3, "a point's color");
  point.error = reader.Read<double>("a point's error");
  CheckPointValues(point, reader.Name());
  const uint64_t count =
      reader.ReadCount(sizeof(TrackElement), "a track's length");
  point.track.resize(count);
  reader.ReadBytes(point.track.data(), count * sizeof(TrackElement), "a track");
  return point;
}

}  // namespace

std::vector<SparseCamera> ReadCamerasBinary(std::istream& stream,
                                            const std::string& name) {
  BinaryReader reader(stream, name);
  const uint64_t count = reader.ReadCount(kMinCameraBytes, "number of cameras");
  std::vector<SparseCamera> cameras;
  cameras.reserve(count);
  for (uint64_t i = 0; i < count; ++i) {
    SparseCamera camera;
    camera.id = reader.Read<uint32_t>("a camera's id");
    const std::string where = fmt::format("camera {}", camera.id);
    camera.model_id = reader.Read<int32_t>(where + ": model");
    camera.width = reader.Read<uint64_t>(where + ": width");
    camera.height = reader.Read<uint64_t>(where + ": height");
    const CameraModelInfo& info =
        RequireCameraModel(camera.model_id, name + ": " + where);
    camera.params.resize(size_t(info.num_params));
    reader.ReadBytes(camera.params.data(),
                     camera.params.size() * sizeof(double),
                     where + ": parameters");
    CheckCamera(camera, name);
    cameras.push_back(std::move(camera));
  }
  reader.ExpectEnd();
  return cameras;
}

std::vector<SparseImage> ReadImagesBinary(std::istream& stream,
                                          const std::string& name) {
  BinaryReader reader(stream, name);
  const uint64_t count = reader.ReadCount(kMinImageBytes, "number of images");
  std::vector<SparseImage> images;
  images.reserve(count);
  for (uint64_t i = 0; i < count; ++i) images.push_back(ReadImage(reader));
  reader.ExpectEnd();
  return images;
}

std::vector<SparsePoint> ReadPointsBinary(std::istream& stream,
                                          const std::string& name) {
  BinaryReader reader(stream, name);
  const uint64_t count = reader.ReadCount(kMinPointBytes, "number of points");
  std::vector<SparsePoint> points;
  points.reserve(count);
  for (uint64_t i = 0; i < count; ++i) points.push_back(ReadPoint(reader));
  reader.ExpectEnd();
  return points;
}

}  // namespace octacut
