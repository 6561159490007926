// The words of the eight nodes around a node, and questions about all of them
// at once: masks with bit c for code c. By vector instructions where every
// machine has them; what they answer is the same.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/cut/octahedron.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace octacut {

class WordsAround {
 public:
  using Array = std::array<int32_t, kNumNodeArcs>;

#ifdef __SSE2__
  explicit WordsAround(const Array& words)
      : halves_{_mm_setr_epi32(words[0], words[1], words[2], words[3]),
                _mm_setr_epi32(words[4], words[5], words[6], words[7])} {
    _mm_store_si128(reinterpret_cast<__m128i*>(words_.data()), halves_[0]);
    _mm_store_si128(reinterpret_cast<__m128i*>(words_.data() + 4), halves_[1]);
  }
#else
  explicit WordsAround(const Array& words) : words_(words) {}
#endif

  int32_t operator[](int code) const { return words_[code]; }

  // Words that equal `word`.
  uint32_t Equal(int32_t word) const;
  // Words w with uint32_t(w - offset) < bound.
  uint32_t Below(int32_t offset, uint32_t bound) const;
  // Words w with (w & mask) == values[code].
  uint32_t Matching(int32_t mask, const Array& values) const;
  // The least uint32_t(w - offset) of the words in the mask `codes`; 2^32 - 1
  // of none.
  uint32_t Least(int32_t offset, uint32_t codes) const;

 private:
#ifdef __SSE2__
  static uint32_t MaskOf(__m128i low, __m128i high) {
    const __m128i lanes = _mm_packs_epi32(low, high);
    return uint32_t(_mm_movemask_epi8(_mm_packs_epi16(lanes, lanes))) & 0xff;
  }
  template <typename Ask>
  uint32_t Mask(Ask&& ask) const {
    return MaskOf(ask(halves_[0]), ask(halves_[1]));
  }
  // Unsigned numbers in the order of signed ones.
  static constexpr int32_t kBias = INT32_MIN;

  __m128i halves_[2];
#endif
  alignas(16) Array words_;
};

#ifdef __SSE2__

inline uint32_t WordsAround::Equal(int32_t word) const {
  const __m128i all = _mm_set1_epi32(word);
  return Mask([&](__m128i half) { return _mm_cmpeq_epi32(half, all); });
}

inline uint32_t WordsAround::Below(int32_t offset, uint32_t bound) const {
  const __m128i shift =
      _mm_set1_epi32(int32_t(uint32_t(kBias) - uint32_t(offset)));
  const __m128i biased = _mm_set1_epi32(int32_t(bound ^ uint32_t(kBias)));
  return Mask([&](__m128i half) {
    return _mm_cmplt_epi32(_mm_add_epi32(half, shift), biased);
  });
}

inline uint32_t WordsAround::Matching(int32_t mask, const Array& values) const {
  const __m128i bits = _mm_set1_epi32(mask);
  const auto equal = [&](size_t half) {
    const __m128i asked = _mm_loadu_si128(
        reinterpret_cast<const __m128i*>(values.data() + 4 * half));
    return _mm_cmpeq_epi32(_mm_and_si128(halves_[half], bits), asked);
  };
  return MaskOf(equal(0), equal(1));
}

inline uint32_t WordsAround::Least(int32_t offset, uint32_t codes) const {
  const __m128i shift =
      _mm_set1_epi32(int32_t(uint32_t(kBias) - uint32_t(offset)));
  const __m128i all_codes = _mm_set1_epi32(int32_t(codes));
  const __m128i greatest = _mm_set1_epi32(INT32_MAX);
  const auto choose = [](__m128i where, __m128i a, __m128i b) {
    return _mm_or_si128(_mm_and_si128(where, a), _mm_andnot_si128(where, b));
  };
  const auto least = [&](__m128i a, __m128i b) {
    return choose(_mm_cmplt_epi32(a, b), a, b);
  };
  const auto asked = [&](int half) {
    const __m128i bits = half == 0 ? _mm_setr_epi32(1, 2, 4, 8)
                                   : _mm_setr_epi32(16, 32, 64, 128);
    const __m128i is_asked =
        _mm_cmpeq_epi32(_mm_and_si128(all_codes, bits), bits);
    return choose(is_asked, _mm_add_epi32(halves_[half], shift), greatest);
  };
  __m128i rest = least(asked(0), asked(1));
  rest = least(rest, _mm_shuffle_epi32(rest, _MM_SHUFFLE(1, 0, 3, 2)));
  rest = least(rest, _mm_shuffle_epi32(rest, _MM_SHUFFLE(2, 3, 0, 1)));
  return uint32_t(_mm_cvtsi128_si32(rest)) ^ uint32_t(kBias);
}

#else

inline uint32_t WordsAround::Equal(int32_t word) const {
  return Matching(-1, {word, word, word, word, word, word, word, word});
}

inline uint32_t WordsAround::Below(int32_t offset, uint32_t bound) const {
  uint32_t mask = 0;
  for (int code = kNumNodeArcs - 1; code >= 0; --code) {
    mask += mask + (uint32_t(words_[code]) - uint32_t(offset) < bound);
  }
  return mask;
}

inline uint32_t WordsAround::Matching(int32_t mask, const Array& values) const {
  uint32_t matching = 0;
  for (int code = kNumNodeArcs - 1; code >= 0; --code) {
    matching += matching + ((words_[code] & mask) == values[code]);
  }
  return matching;
}

inline uint32_t WordsAround::Least(int32_t offset, uint32_t codes) const {
  uint32_t least = UINT32_MAX;
  for (int code = 0; code < kNumNodeArcs; ++code) {
    const uint32_t rank = uint32_t(words_[code]) - uint32_t(offset);
    least = std::min(least, rank | (((codes >> code) & 1) - 1));
  }
  return least;
}

#endif

}  // namespace octacut
