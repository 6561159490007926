// Binary readers on damaged files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <random>
#include <sstream>

#include "colmap_io/model/read_sparse_model.h"
#include "colmap_io/model/write_sparse_model.h"
#include "tests/colmap_io/model/test_models.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;

struct Part {
  const char* name;
  std::string bytes;
  std::function<void(std::istream&)> read;
};

// The three files of a small model with what reads them.
std::vector<Part> Parts(const SparseModel& model) {
  std::ostringstream cameras, images, points;
  WriteCamerasBinary(model.cameras, cameras);
  WriteImagesBinary(model.images, images);
  WritePointsBinary(model.points, points);
  return {{"cameras.bin",
           cameras.str(),
           [](std::istream& s) { ReadCamerasBinary(s, "cameras.bin"); }},
          {"images.bin",
           images.str(),
           [](std::istream& s) { ReadImagesBinary(s, "images.bin"); }},
          {"points3D.bin", points.str(), [](std::istream& s) {
             ReadPointsBinary(s, "points3D.bin");
           }}};
}

std::string Message(const Part& part, const std::string& bytes) {
  return InputErrorOf([&] {
    std::istringstream stream(bytes);
    part.read(stream);
  });
}

// A stream that can only be read forward, as a pipe.
class ForwardBuffer : public std::streambuf {
 public:
  explicit ForwardBuffer(std::string bytes) : bytes_(std::move(bytes)) {
    setg(bytes_.data(), bytes_.data(), bytes_.data() + bytes_.size());
  }

 private:
  std::string bytes_;
};

TEST(ReadBinary, TruncatedAnywhereIsRefused) {
  for (const Part& part : Parts(TestModel(3, 4, 6))) {
    for (size_t size = 0; size < part.bytes.size(); ++size) {
      ASSERT_THAT(Message(part, part.bytes.substr(0, size)),
                  HasSubstr(part.name))
          << size;
    }
    ASSERT_EQ(Message(part, part.bytes), "no InputError");
  }
}

TEST(ReadBinary, TrailingBytesAreRefused) {
  for (const Part& part : Parts(TestModel(3, 4, 6))) {
    EXPECT_THAT(Message(part, part.bytes + "x"),
                HasSubstr("1 bytes follow after the end"));
  }
}

TEST(ReadBinary, StreamsThatCannotSeekAreReadToo) {
  for (const Part& part : Parts(TestModel(3, 4, 6))) {
    ForwardBuffer whole(part.bytes);
    std::istream stream(&whole);
    EXPECT_NO_THROW(part.read(stream));
    ForwardBuffer half(part.bytes.substr(0, part.bytes.size() / 2));
    std::istream short_stream(&half);
    EXPECT_THROW(part.read(short_stream), InputError);
  }
}

// Counts that the bytes cannot hold are refused before memory is taken: with
// these, taking it would fail.
TEST(ReadBinary, HugeCountsAreRefused) {
  for (const Part& part : Parts(TestModel(3, 4, 6))) {
    for (const uint64_t count : {~uint64_t(0),
                                 uint64_t(1) << 62,
                                 uint64_t(1) << 40,
                                 uint64_t(part.bytes.size())}) {
      std::string bytes = part.bytes;
      std::memcpy(bytes.data(), &count, sizeof(count));
      EXPECT_THAT(Message(part, bytes), HasSubstr("bytes hold at most"));
    }
  }
  SparseModel model;
  model.cameras = {{1, 0, 640, 480, {500, 320, 240}}};
  model.images.resize(1);
  model.images[0].id = 5;
  model.images[0].name = "a";
  Part images = Parts(model)[1];
  const uint64_t count = 1ull << 61;  // times 24 overflows
  std::memcpy(images.bytes.data() + images.bytes.size() - 8, &count, 8);
  EXPECT_THAT(
      Message(images, images.bytes),
      HasSubstr("image 5: number of observations = 2305843009213693952"));
}

// Values as COLMAP's own files could never have them.
TEST(ReadBinary, BadValuesAreNamed) {
  const auto image_message = [](const std::function<void(SparseImage&)>& f) {
    SparseModel model = TestModel(3, 1, 0);
    f(model.images[0]);
    const Part part = Parts(model)[1];
    return Message(part, part.bytes);
  };
  EXPECT_THAT(image_message([](auto& i) { i.rotation.x() = NAN; }),
              HasSubstr("images.bin: image 7 (folder 0/"));
  EXPECT_THAT(image_message([](auto& i) { i.rotation.x() = NAN; }),
              HasSubstr("qx = nan: must be finite"));
  EXPECT_THAT(image_message([](auto& i) { i.translation.z() = INFINITY; }),
              HasSubstr("tz = inf: must be finite"));
  EXPECT_THAT(image_message([](auto& i) { i.rotation.coeffs().setZero(); }),
              HasSubstr("quaternion qw qx qy qz = 0 0 0 0"));
  EXPECT_THAT(image_message([](auto& i) { i.observations[2].y = NAN; }),
              HasSubstr("image 7: observation 2"));
  SparseModel model = TestModel(3, 1, 1);
  model.points[0].xyz.y() = NAN;
  const Part points = Parts(model)[2];
  EXPECT_THAT(Message(points, points.bytes), HasSubstr("must be finite"));
}

TEST(ReadBinary, NormalizesQuaternionsOnce) {
  SparseModel model = TestModel(3, 1, 0);
  model.images[0].rotation = Eigen::Quaterniond(2, -2, 2, -2);
  std::stringstream stream;
  WriteImagesBinary(model.images, stream);
  const auto images = ReadImagesBinary(stream, "images.bin");
  EXPECT_EQ(images[0].rotation.coeffs(),
            Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5).coeffs());
}

TEST(ReadBinary, RefusesModelsByName) {
  SparseCamera camera{4, 17, 640, 320, {640, 320}};
  std::stringstream stream;
  WriteCamerasBinary({camera, camera}, stream);
  EXPECT_THAT(InputErrorOf([&] { ReadCamerasBinary(stream, "cameras.bin"); }),
              ::testing::AllOf(HasSubstr("cameras.bin: camera 4"),
                               HasSubstr("EQUIRECTANGULAR")));
}

// Random damage never does worse than an InputError.
TEST(ReadBinary, SurvivesRandomDamage) {
  const std::vector<Part> parts = Parts(TestModel(3, 4, 6));
  std::mt19937 random(20240607);
  int num_refused = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const Part& part = parts[size_t(trial) % parts.size()];
    std::string bytes = part.bytes;
    const int num_changes = 1 + int(random() % 4);
    for (int i = 0; i < num_changes; ++i) {
      // Mostly single bits; often among the first bytes, where counts are.
      const size_t range = random() % 2 ? bytes.size() : size_t(40);
      char& byte = bytes[random() % std::min(range, bytes.size())];
      byte = random() % 2 ? char(random()) : char(byte ^ (1 << random() % 8));
    }
    if (random() % 8 == 0) bytes.resize(random() % bytes.size());
    num_refused += Message(part, bytes) != "no InputError";
  }
  EXPECT_GT(num_refused, 1000);
}

}  // namespace
}  // namespace octacut
