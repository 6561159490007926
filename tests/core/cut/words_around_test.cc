#include "core/cut/words_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace octacut {
namespace {

using Array = WordsAround::Array;

constexpr int32_t kOffset = 128;

// Words of nodes and of none, and any numbers at the ends of their range.
Array RandomWords(std::mt19937& random) {
  const Array known = {
      8, 15, -120, 128, 128 + 127, INT32_MAX, INT32_MIN, INT32_MIN + kOffset};
  Array words;
  for (int32_t& word : words) {
    word = random() % 2 ? known[random() % known.size()] : int32_t(random());
    word = random() % 3 ? word : int32_t(random() % 1024);
  }
  return words;
}

template <typename Ask>
uint32_t MaskOf(Ask&& ask) {
  uint32_t mask = 0;
  for (int code = 0; code < kNumNodeArcs; ++code) {
    mask |= uint32_t(ask(code)) << code;
  }
  return mask;
}

TEST(WordsAround, AnswersAreThoseOfEveryWordAlone) {
  std::mt19937 random(1);
  size_t num_equal = 0, num_below = 0, num_matching = 0;
  for (int k = 0; k < 20000; ++k) {
    const Array array = RandomWords(random);
    const WordsAround words(array);
    const auto rank = [&](int code) {
      return uint32_t(array[code]) - uint32_t(kOffset);
    };
    for (int code = 0; code < kNumNodeArcs; ++code) {
      ASSERT_EQ(words[code], array[code]);
    }

    const int32_t word = array[random() % array.size()];
    const uint32_t equal = MaskOf([&](int c) { return array[c] == word; });
    ASSERT_EQ(words.Equal(word), equal);

    const uint32_t bounds[] = {
        0, 1, 128, 1u << 31, UINT32_MAX, rank(3), uint32_t(random())};
    for (const uint32_t bound : bounds) {
      const uint32_t below = MaskOf([&](int c) { return rank(c) < bound; });
      ASSERT_EQ(words.Below(kOffset, bound), below) << bound;
      num_below += below != 0 && below != 0xff;
    }

    Array values;
    for (int32_t& value : values) {
      value = int32_t(random() % 16);
    }
    const uint32_t matching =
        MaskOf([&](int c) { return (array[c] & 15) == values[c]; });
    ASSERT_EQ(words.Matching(15, values), matching);

    const uint32_t codes = random() % 4 ? random() % 256 : 0;
    uint32_t least = UINT32_MAX;
    for (int code = 0; code < kNumNodeArcs; ++code) {
      least = (codes >> code) & 1 ? std::min(least, rank(code)) : least;
    }
    ASSERT_EQ(words.Least(kOffset, codes), least) << codes;
    num_equal += equal != 0xff;
    num_matching += matching != 0;
  }
  EXPECT_GT(num_equal, 10000);
  EXPECT_GT(num_below, 10000);
  EXPECT_GT(num_matching, 5000);
}

}  // namespace
}  // namespace octacut
