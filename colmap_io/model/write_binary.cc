#include <bit>

#include "colmap_io/model/write_sparse_model.h"

namespace octacut {
namespace {

static_assert(std::endian::native == std::endian::little,
              "binary models are copied as they are: little endian");

template <typename T>
void Put(const T& value, std::ostream& stream) {
  stream.write(reinterpret_cast<const char*>(&value), sizeof(T));
}

template <typename T>
void PutAll(const std::vector<T>& values, std::ostream& stream) {
  stream.write(reinterpret_cast<const char*>(values.data()),
               std::streamsize(values.size() * sizeof(T)));
}

void PutVector(const Eigen::Vector3d& v, std::ostream& stream) {
  for (int i = 0; i < 3; ++i) Put(v[i], stream);
}

}  // namespace

void WriteCamerasBinary(const std::vector<SparseCamera>& cameras,
                        std::ostream& stream) {
  Put(uint64_t(cameras.size()), stream);
  for (const SparseCamera& camera : cameras) {
    Put(camera.id, stream);
    Put(int32_t(camera.model_id), stream);
    Put(camera.width, stream);
    Put(camera.height, stream);
    PutAll(camera.params, stream);
  }
}

void WriteImagesBinary(const std::vector<SparseImage>& images,
                       std::ostream& stream) {
  Put(uint64_t(images.size()), stream);
  for (const SparseImage& image : images) {
    Put(image.id, stream);
    Put(image.rotation.w(), stream);
    PutVector(image.rotation.vec(), stream);
    PutVector(image.translation, stream);
    Put(image.camera_id, stream);
    stream.write(image.name.c_str(), std::streamsize(image.name.size() + 1));
    Put(uint64_t(image.observations.size()), stream);
    PutAll(image.observations, stream);
  }
}

void WritePointsBinary(const std::vector<SparsePoint>& points,
                       std::ostream& stream) {
  Put(uint64_t(points.size()), stream);
  for (const SparsePoint& point : points) {
    Put(point.id, stream);
    PutVector(point.xyz, stream);
    Put(point.rgb, stream);
    Put(point.error, stream);
    Put(uint64_t(point.track.size()), stream);
    PutAll(point.track, stream);
  }
}

}  // namespace octacut
