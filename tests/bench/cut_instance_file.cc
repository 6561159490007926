#include "tests/bench/cut_instance_file.h"

#include <fmt/format.h>

#include <bit>
#include <fstream>

#include "colmap_io/files/atomic_files.h"
#include "core/base/error.h"

namespace octacut {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr uint64_t kMagic = 0x3141544f43544f31ull;
constexpr uint64_t kMagicWithEvidence = 0x3141544f43544f32ull;

template <typename T>
void Read(std::istream& stream, std::vector<T>& values, size_t count) {
  values.resize(count);
  stream.read(reinterpret_cast<char*>(values.data()),
              std::streamsize(count * sizeof(T)));
}

template <typename T>
void Write(std::ostream& stream, const std::vector<T>& values) {
  stream.write(reinterpret_cast<const char*>(values.data()),
               std::streamsize(values.size() * sizeof(T)));
}

VoxelGrid GridOf(const std::vector<uint16_t>& xyz,
                 uint64_t resolution,
                 const std::string& path) {
  std::vector<VoxelGrid::Brick> bricks;
  MortonCode previous = 0;
  for (size_t i = 0; 3 * i < xyz.size(); ++i) {
    const uint16_t* voxel = &xyz[3 * i];
    const MortonCode code = EncodeMorton(voxel[0], voxel[1], voxel[2]);
    if ((i > 0 && code <= previous) || voxel[0] >= resolution ||
        voxel[1] >= resolution || voxel[2] >= resolution) {
      throw InputError(
          fmt::format("{}: voxel {} is out of order or range", path, i));
    }
    if (bricks.empty() || bricks.back().key != code >> 6) {
      bricks.push_back({code >> 6, 0, 0});
    }
    bricks.back().mask |= uint64_t{1} << (code & 63);
    previous = code;
  }
  return VoxelGrid::FromBricks(std::bit_width(resolution - 1),
                               std::move(bricks));
}

}  // namespace

CutInstance ReadCutInstance(const std::string& path) {
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const uint64_t size = stream ? uint64_t(stream.tellg()) : 0;
  stream.seekg(0);
  std::vector<uint64_t> header(3);
  Read(stream, header, 3);
  const bool with_evidence = header[0] == kMagicWithEvidence;
  if (!stream || (header[0] != kMagic && !with_evidence)) {
    throw InputError(path + ": not a cut instance");
  }
  const uint64_t resolution = header[1];
  const uint64_t per_voxel = with_evidence ? 16 : 12;
  if (resolution < 1 || resolution > 65536 || (size - 24) % per_voxel != 0 ||
      (size - 24) / per_voxel != header[2]) {
    throw InputError(fmt::format("{}: {} voxels at {}^3 do not fit {} bytes",
                                 path,
                                 header[2],
                                 resolution,
                                 size));
  }
  CutInstance instance;
  instance.name = path;
  std::vector<uint16_t> xyz;
  Read(stream, xyz, 3 * header[2]);
  Read(stream, instance.weights, header[2]);
  Read(stream, instance.ties, header[2]);
  if (with_evidence) {
    Read(stream, instance.evidence, header[2]);
  }
  if (!stream) {
    throw InputError(path + ": cannot be read");
  }
  instance.crust = GridOf(xyz, resolution, path);
  return instance;
}

void WriteCutInstance(const CutInstance& instance, const std::string& path) {
  const bool with_evidence = !instance.evidence.empty();
  const std::vector<uint64_t> header = {
      with_evidence ? kMagicWithEvidence : kMagic,
      uint64_t(instance.crust.Resolution()),
      instance.crust.Size()};
  std::vector<uint16_t> xyz;
  xyz.reserve(3 * instance.crust.Size());
  instance.crust.ForEach([&](VoxelGrid::Index, MortonCode code) {
    const Eigen::Vector3i voxel = DecodeMorton(code);
    for (int axis = 0; axis < 3; ++axis) {
      xyz.push_back(uint16_t(voxel[axis]));
    }
  });
  WriteFile(path, [&](std::ostream& stream) {
    Write(stream, header);
    Write(stream, xyz);
    Write(stream, instance.weights);
    Write(stream, instance.ties);
    Write(stream, instance.evidence);
  });
}

void WriteCutLabels(const std::vector<FaceLabels>& labels,
                    const std::string& path) {
  WriteFile(path, [&](std::ostream& stream) { Write(stream, labels); });
}

}  // namespace octacut
