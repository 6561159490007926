// Round trips and the checks of a whole model.
#include "colmap_io/model/sparse_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <locale>
#include <sstream>

#include "colmap_io/model/read_sparse_model.h"
#include "colmap_io/model/write_sparse_model.h"
#include "tests/colmap_io/model/test_models.h"
#include "tests/colmap_io/model/text_model.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class SparseModelFolder : public ModelFolderTest {};

TEST_F(SparseModelFolder, BinaryAndTextRoundTripBitForBit) {
  for (uint32_t seed = 1; seed <= 3; ++seed) {
    const SparseModel model = TestModel(seed, 30, 40);
    WriteSparseModelBinary(model, folder_ / "bin");
    WriteTextModel(model, folder_ / "txt");
    ExpectSameModel(model, ReadSparseModel(folder_ / "bin"));
    ExpectSameModel(model, ReadSparseModel(folder_ / "txt"));
    // Over both formats and back: still the same.
    WriteTextModel(ReadSparseModel(folder_ / "bin"), folder_ / "txt2");
    WriteSparseModelBinary(ReadSparseModel(folder_ / "txt2"), folder_ / "bin2");
    ExpectSameModel(model, ReadSparseModel(folder_ / "bin2"));
    EXPECT_EQ(CountSparseImages(folder_ / "bin"), 30u);
    EXPECT_EQ(CountSparseImages(folder_ / "txt"), 30u);
  }
}

TEST_F(SparseModelFolder, EmptyModelRoundTrips) {
  WriteSparseModelBinary({}, folder_ / "bin");
  WriteTextModel({}, folder_ / "txt");
  ExpectSameModel({}, ReadSparseModel(folder_ / "bin"));
  ExpectSameModel({}, ReadSparseModel(folder_ / "txt"));
}

TEST_F(SparseModelFolder, PrefersACompleteBinaryModel) {
  const SparseModel text = TestModel(1, 3, 5);
  const SparseModel binary = TestModel(2, 4, 5);
  WriteTextModel(text, folder_);
  WriteSparseModelBinary(binary, folder_);
  ExpectSameModel(binary, ReadSparseModel(folder_));
  fs::remove(folder_ / "points3D.bin");
  ExpectSameModel(text, ReadSparseModel(folder_));
}

TEST_F(SparseModelFolder, SaysWhichFileIsMissing) {
  const auto message = [&] {
    return InputErrorOf([&] { ReadSparseModel(folder_); });
  };
  EXPECT_THAT(message(), HasSubstr("holds no sparse model"));
  WriteSparseModelBinary(TestModel(1, 3, 5), folder_);
  fs::remove(folder_ / "images.bin");
  EXPECT_THAT(
      message(),
      AllOf(HasSubstr(folder_.string()), HasSubstr("images.bin missing")));
  fs::remove(folder_ / "cameras.bin");
  EXPECT_THAT(message(), HasSubstr("cameras.bin and images.bin missing"));
  EXPECT_THAT(InputErrorOf([&] { ReadSparseModel(folder_ / "none"); }),
              HasSubstr("no such folder"));
  EXPECT_THAT(InputErrorOf([&] { CountSparseImages(folder_); }),
              HasSubstr("missing"));
}

TEST_F(SparseModelFolder, ReadsModelsWithRigsAndFrames) {
  const SparseModel model = TestModel(1, 3, 5);
  WriteSparseModelBinary(model, folder_);
  std::ofstream(folder_ / "rigs.bin") << "whatever";
  std::ofstream(folder_ / "frames.bin") << "";
  ExpectSameModel(model, ReadSparseModel(folder_));
  // But does not leave them beside another model.
  EXPECT_THAT(InputErrorOf([&] { WriteSparseModelBinary(model, folder_); }),
              HasSubstr("rigs.bin"));
}

TEST_F(SparseModelFolder, WriterLeavesNothingBehindWhenItFails) {
  const SparseModel model = TestModel(1, 3, 5);
  // A folder in the way of the last file.
  fs::create_directories(folder_ / "points3D.bin" / "x");
  EXPECT_THROW(WriteSparseModelBinary(model, folder_), Error);
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_THAT(entry.path().filename().string(),
                ::testing::Not(HasSubstr("tmp")));
  }
  SparseModel bad = model;
  bad.images[0].camera_id = 99;
  EXPECT_THROW(WriteSparseModelBinary(bad, folder_ / "new"), InputError);
  EXPECT_FALSE(fs::exists(folder_ / "new"));
  bad = model;
  bad.images[0].name = std::string("a\0b", 3);
  EXPECT_THROW(WriteSparseModelBinary(bad, folder_ / "new"), InputError);
}

// A locale of its own instead of an installed one: decimal commas and
// grouped thousands.
struct CommaDecimals : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_F(SparseModelFolder, TextIsReadUnderAnyLocale) {
  const SparseModel model = TestModel(5, 10, 20);
  WriteTextModel(model, folder_);
  const std::locale previous =
      std::locale::global(std::locale(std::locale(), new CommaDecimals));
  // Where a locale with decimal commas is installed the C library has it too.
  const char* installed = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const SparseModel read = ReadSparseModel(folder_);
  if (installed != nullptr) std::setlocale(LC_ALL, "C");
  std::locale::global(previous);
  ExpectSameModel(model, read);
}

TEST(CheckSparseModel, RefusesEachInconsistency) {
  const SparseModel good = TestModel(1, 6, 8);
  EXPECT_NO_THROW(CheckSparseModel(good));
  const auto message = [&](const std::function<void(SparseModel&)>& change) {
    SparseModel bad = good;
    change(bad);
    return InputErrorOf([&] { CheckSparseModel(bad, {"C", "I", "P"}); });
  };
  EXPECT_THAT(message([](auto& m) { m.cameras[1].id = m.cameras[0].id; }),
              HasSubstr("C: camera id 1 occurs twice"));
  EXPECT_THAT(message([](auto& m) { m.images[1].id = m.images[0].id; }),
              HasSubstr("I: image id 7 occurs twice"));
  EXPECT_THAT(message([](auto& m) { m.points[2].id = m.points[1].id; }),
              HasSubstr("P: point id 997 occurs twice"));
  EXPECT_THAT(message([](auto& m) { m.images[2].camera_id = 77; }),
              AllOf(HasSubstr("I: image "),
                    HasSubstr("camera_id = 77: C has no such camera")));
  EXPECT_THAT(
      message([](auto& m) { m.images[2].observations[1].point3D_id = 5; }),
      HasSubstr("observation 1 has point3D_id = 5: P has no such point"));
  EXPECT_THAT(message([](auto& m) {
                m.points[1].track = {{999, 0}};
              }),
              HasSubstr("P: point 997: track has image_id = 999"));
  EXPECT_THAT(message([](auto& m) {
                m.points[1].track = {{m.images[0].id, 5}};
              }),
              HasSubstr("track has point2D_idx = 5 of image 7, which has 5"));
  EXPECT_THAT(message([](auto& m) { m.images[0].name.clear(); }),
              HasSubstr("name is empty"));
  for (const char* name : {"../a.jpg", "a/../../b.jpg", "/a.jpg"}) {
    EXPECT_THAT(message([&](auto& m) { m.images[0].name = name; }),
                AllOf(HasSubstr(name), HasSubstr("must be a path below")));
  }
  EXPECT_EQ(message([](auto& m) { m.images[0].name = "a..b/..c.jpg"; }),
            "no InputError");
  EXPECT_THAT(message([](auto& m) { m.images[2].name = m.images[1].name; }),
              AllOf(HasSubstr("I: images 32 and 27 have the same name"),
                    HasSubstr(good.images[1].name)));
  EXPECT_THAT(message([](auto& m) { m.images[0].translation.x() = 1e30; }),
              HasSubstr("translation of length 1e+30: must be at most"));
  EXPECT_THAT(message([](auto& m) { m.images[0].rotation.w() = 3; }),
              HasSubstr("quaternion of length"));
  EXPECT_THAT(message([](auto& m) { m.images[0].translation.x() = NAN; }),
              HasSubstr("not finite"));
  EXPECT_THAT(message([](auto& m) { m.cameras[0].params[0] = -1; }),
              HasSubstr("C: camera 1"));
  EXPECT_EQ(good.FindCamera(3), &good.cameras[2]);
  EXPECT_EQ(good.FindCamera(1000), nullptr);
}

}  // namespace
}  // namespace octacut
