#include "core/print/marker_scale.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "tests/core/print/marker_images.h"

namespace octacut {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kFocal = 800;

// `noise` in pixels, to either side.
MarkerSighting See(const PrintedMarker& marker,
                   const Eigen::Vector3d& center,
                   double noise = 0) {
  MarkerSighting sighting;
  sighting.id = marker.id;
  sighting.cam_from_world = LookAtOrigin(center);
  sighting.focal_length = kFocal;
  for (int corner = 0; corner < 4; ++corner) {
    Eigen::Vector3d ray = sighting.cam_from_world * marker.Corners()[corner];
    ray /= ray.z();
    for (int axis = 0; axis < 2; ++axis) {
      ray[axis] += noise / kFocal *
                   (2 * HashUniform(HashBits(uint64_t(corner),
                                             uint64_t(axis),
                                             uint64_t(1000 * center.x() + 5000),
                                             uint64_t(marker.id))) -
                    1);
    }
    sighting.rays[corner] = ray;
  }
  return sighting;
}

const PrintedMarker kFirst{3, {-0.6, 0.4}, 0.5};
const PrintedMarker kSecond{8, {0.1, 0.4}, 0.5};

TEST(MeasureMarkerScale, ExactRaysGiveTheExactScale) {
  const MarkerScale scale = MeasureMarkerScale(
      {See(kFirst, {1, -2, 2}), See(kFirst, {-1, -2, 2})}, 25);
  EXPECT_NEAR(scale.factor, 50, 1e-9);
  ASSERT_EQ(scale.markers.size(), 1u);
  EXPECT_EQ(scale.markers[0].num_views, 2u);
  for (int corner = 0; corner < 4; ++corner) {
    EXPECT_LT(
        (scale.markers[0].corners[corner] - kFirst.Corners()[corner]).norm(),
        1e-9);
  }
  EXPECT_LT(scale.reprojection_rms, 1e-6);
  EXPECT_LT(scale.side_max, 1e-9);
}

TEST(MeasureMarkerScale, NoiseAveragesOut) {
  std::vector<MarkerSighting> sightings;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d center =
        Eigen::AngleAxisd(0.5 * i, Eigen::Vector3d::UnitZ()) *
        Eigen::Vector3d(2, 0, 2);
    sightings.push_back(See(kFirst, center, 0.5));
    sightings.push_back(See(kSecond, center, 0.5));
  }
  const MarkerScale scale = MeasureMarkerScale(sightings, 25);
  EXPECT_NEAR(scale.factor, 50, 0.05);
  EXPECT_NEAR(scale.reprojection_rms, 0.4, 0.1);
  EXPECT_GT(scale.side_rms, 0);
  EXPECT_LT(scale.side_max, 0.005);
}

TEST(MeasureMarkerScale, AViewThatIsWrongIsLeftOut) {
  std::vector<MarkerSighting> sightings = {See(kFirst, {1, -2, 2}),
                                           See(kFirst, {-1, -2, 2}),
                                           See(kFirst, {0, -2, 2.5})};
  PrintedMarker elsewhere = kFirst;
  elsewhere.corner.x() += 0.1;
  sightings.push_back(See(elsewhere, {0.5, -2, 2}));
  const MarkerScale scale = MeasureMarkerScale(sightings, 25);
  EXPECT_NEAR(scale.factor, 50, 1e-6);
  EXPECT_EQ(scale.markers[0].num_views, 3u);
}

TEST(MeasureMarkerScale, SaysWhyThereIsNone) {
  EXPECT_THAT([] { MeasureMarkerScale({}, 25); },
              ThrowsMessage<InputError>(HasSubstr("show no ArUco marker")));
  const auto fails = ThrowsMessage<InputError>(
      HasSubstr("show 1 different ArUco markers, but none of them in two "
                "views"));
  EXPECT_THAT([] { MeasureMarkerScale({See(kFirst, {1, -2, 2})}, 25); }, fails);
  // One degree apart.
  EXPECT_THAT(
      [] {
        MeasureMarkerScale(
            {See(kFirst, {0, -2, 2}), See(kFirst, {0.045, -2, 2})}, 25);
      },
      fails);
}

}  // namespace
}  // namespace octacut
