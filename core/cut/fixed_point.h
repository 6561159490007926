// The fixed point in which cuts are solved: units of 2^-20, so that a cut is
// exact, adds up in any order and is the same on every machine.
#pragma once

#include <cstdint>

namespace octacut {

inline constexpr int kCutFractionBits = 20;
inline constexpr double kFixedOne = double(1 << kCutFractionBits);

// Largest capacity of one arc or one voxel's share of a face's evidence: a
// residual is at most twice that and a face sums two shares, both of which
// still fit an int32_t.
inline constexpr int32_t kMaxFixedCapacity = (1 << 30) - 1;
// The same in units of the weights, rounded down.
inline constexpr float kMaxCutWeight = 1023.0f;
// The largest evidence of a voxel, in magnitude.
inline constexpr float kMaxEvidence = 6 * kMaxCutWeight;

// `weight` in (0, kMaxCutWeight].
inline int32_t FixedWeight(float weight) {
  // Weights are positive, and std::lround is a function call.
  // NOLINTNEXTLINE(bugprone-incorrect-roundings)
  const int32_t fixed = int32_t(double(weight) * kFixedOne + 0.5);
  return fixed < 1 ? 1 : fixed;
}

// A voxel's share in the evidence of each of its six faces, signed;
// |evidence| at most kMaxEvidence.
inline int32_t FixedFaceEvidence(float evidence) {
  const double share = double(evidence) / 6 * kFixedOne;
  return int32_t(share + (share < 0 ? -0.5 : 0.5));
}

// For lean cuts: weights are in units of 2^-14, and the largest one is what
// flows of 16 bits can hold.
inline constexpr int kLeanFractionBits = 14;
inline constexpr int32_t kMaxLeanWeight = (1 << 15) - 1;

// The unit of a cut: 2^(shift - 20). In a coarser one weights and flows fit
// fewer bits, and the cut is a minimum of what they were rounded to.
struct CutScale {
  int shift = 0;

  int32_t Weight(float weight) const {
    const int32_t fixed = Rounded(FixedWeight(weight));
    return fixed < 1 ? 1 : fixed;
  }
  int32_t FaceEvidence(float evidence) const {
    return Rounded(FixedFaceEvidence(evidence));
  }
  int32_t Rounded(int32_t fixed) const {
    return int32_t((int64_t{fixed} + (int64_t{1} << shift) / 2) >> shift);
  }
};

inline double FromFixed(int64_t value) { return double(value) / kFixedOne; }

}  // namespace octacut
