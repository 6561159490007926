#include "core/refine/offset_support.h"

#include <gtest/gtest.h>

#include "tests/core/refine/refine_scene.h"

namespace octacut {
namespace {

constexpr int kSide = 40;
constexpr double kTolerance = 0.01;

// Points in a square, each with those beside it.
VertexCorners SquareOfPoints() {
  std::vector<std::array<uint32_t, 3>> triangles;
  for (uint32_t y = 0; y + 1 < kSide; ++y) {
    for (uint32_t x = 0; x + 1 < kSide; ++x) {
      const uint32_t i = y * kSide + x;
      triangles.push_back({i, i + 1, i + kSide});
      triangles.push_back({i + 1, i + kSide + 1, i + kSide});
    }
  }
  return FindVertexNeighbors(kSide * kSide, triangles);
}

// Any number in -1 .. 1, the same for the same point.
float RandomOf(size_t point) {
  return float((point * 2654435761u >> 7) % 1000) / 500 - 1;
}

// Offsets of all points; `is_chance` says which of them are arbitrary.
template <typename IsChance>
std::vector<OffsetMeasurement> Offsets(IsChance&& is_chance) {
  std::vector<OffsetMeasurement> measurements(kSide * kSide);
  for (size_t i = 0; i < measurements.size(); ++i) {
    measurements[i].offset =
        is_chance(i) ? 0.1f * RandomOf(i) : 0.02f + 0.001f * RandomOf(i);
    measurements[i].weight = 5;
  }
  return measurements;
}

void Drop(std::vector<OffsetMeasurement>* measurements) {
  DropChanceOffsets(SquareOfPoints(),
                    std::vector<uint8_t>(measurements->size(), 1),
                    kTolerance,
                    Context(2),
                    measurements);
}

TEST(DropChanceOffsets, DropsThoseThatNoneSupports) {
  std::vector<OffsetMeasurement> measurements =
      Offsets([](size_t) { return true; });
  Drop(&measurements);
  EXPECT_LT(NumMeasured(measurements), measurements.size() / 20);
}

TEST(DropChanceOffsets, KeepsTheRightOnesAmongThem) {
  // The left third of the square is right.
  const auto is_chance = [](size_t point) { return point % kSide >= 14; };
  std::vector<OffsetMeasurement> measurements = Offsets(is_chance);
  Drop(&measurements);
  for (size_t i = 0; i < measurements.size(); ++i) {
    if (i % kSide < 8) {
      EXPECT_EQ(measurements[i].weight, 5) << i;
    } else if (i % kSide > 20) {
      EXPECT_LT(measurements[i].weight, 2.5f) << i;
    }
  }
}

TEST(DropChanceOffsets, LeavesWhatMostlyHasSupport) {
  // A crease, on which offsets differ.
  const auto is_chance = [](size_t point) {
    return point % kSide >= 18 && point % kSide < 22;
  };
  std::vector<OffsetMeasurement> measurements = Offsets(is_chance);
  Drop(&measurements);
  EXPECT_EQ(NumMeasured(measurements), measurements.size());
  for (const OffsetMeasurement& measurement : measurements) {
    EXPECT_EQ(measurement.weight, 5);
  }
}

}  // namespace
}  // namespace octacut
