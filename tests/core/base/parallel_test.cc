#include "core/base/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "core/base/with_threads.h"

namespace octacut {
namespace {

using std::chrono::steady_clock;

TEST(ParallelFor, VisitsEveryIndexOnceInChunksThatDependOnSizesAlone) {
  for (const size_t count : {0u, 1u, 7u, 1000u}) {
    for (const int num_threads : {1, 2, 4}) {
      std::vector<int> visits(count, 0);
      std::vector<size_t> begins(NumChunks(count, 9), 0);
      ParallelChunks(Context(num_threads),
                     count,
                     9,
                     [&](size_t chunk, size_t begin, size_t end) {
                       begins[chunk] = begin;
                       EXPECT_EQ(end, std::min(count, begin + 9));
                       for (size_t i = begin; i < end; ++i) {
                         ++visits[i];
                       }
                     });
      EXPECT_EQ(std::count(visits.begin(), visits.end(), 1),
                std::ptrdiff_t(count));
      for (size_t chunk = 0; chunk < begins.size(); ++chunk) {
        EXPECT_EQ(begins[chunk], 9 * chunk);
      }
    }
  }
}

TEST(ParallelEach, VisitsEveryIndexOnceInOrderWithinAChunk) {
  for (const size_t count : {0u, 1u, 7u, 1000u}) {
    for (const int num_threads : {1, 4}) {
      std::vector<std::vector<size_t>> visited(NumChunks(count, 9));
      ParallelEach(Context(num_threads), count, 9, [&](size_t i) {
        visited[i / 9].push_back(i);
      });
      size_t next = 0;
      for (const std::vector<size_t>& chunk : visited) {
        for (const size_t i : chunk) {
          EXPECT_EQ(i, next++);
        }
      }
      EXPECT_EQ(next, count);
    }
  }
}

TEST(ParallelSum, AddsWhatEveryChunkGives) {
  for (const int num_threads : {1, 4}) {
    const auto sum = [&](size_t count) {
      return ParallelSum(
          Context(num_threads), count, 9, [](size_t begin, size_t end) {
            int64_t part = 0;
            for (size_t i = begin; i < end; ++i) {
              part += int64_t(i) - 10;
            }
            return part;
          });
    };
    EXPECT_EQ(sum(0), 0);
    EXPECT_EQ(sum(5), -40);
    EXPECT_EQ(sum(1000), 489500);
  }
}

TEST(ParallelFor, PassesExceptionsOn) {
  for (const int num_threads : {1, 4}) {
    EXPECT_THROW(ParallelFor(Context(num_threads),
                             100,
                             1,
                             [](size_t begin, size_t) {
                               if (begin == 50) throw InputError("bad");
                             }),
                 InputError);
  }
}

TEST(ParallelFor, EndsWhenCancelled) {
  for (const int num_threads : {1, 4}) {
    std::atomic<bool> cancelled(false);
    std::atomic<size_t> calls(0);
    const Context context(num_threads, nullptr, &cancelled);
    EXPECT_THROW(ParallelFor(context,
                             1000000,
                             1,
                             [&](size_t, size_t) {
                               ++calls;
                               cancelled = true;
                             }),
                 CancelledError);
    EXPECT_LE(calls, 4u);
  }
}

// How many of `num_threads` bodies run at the same time, waiting for each
// other until `patience` is over.
int RunTogether(int num_threads, std::chrono::milliseconds patience) {
  std::atomic<int> waiting(0);
  const auto deadline = steady_clock::now() + patience;
  ParallelFor(
      Context(num_threads), size_t(num_threads), 1, [&](size_t, size_t) {
        ++waiting;
        while (waiting < num_threads && steady_clock::now() < deadline) {
          std::this_thread::yield();
        }
        if (steady_clock::now() >= deadline) --waiting;
      });
  return waiting;
}

// main() of the tests asks for them.
TEST(WithThreads, LoopsGetFourThreadsEvenOnFewerCores) {
  EXPECT_EQ(RunTogether(4, std::chrono::seconds(20)), 4);
}

TEST(WithThreads, PassesExceptionsOn) {
  EXPECT_THROW(WithThreads(3, [] { throw InputError("bad"); }), InputError);
}

}  // namespace
}  // namespace octacut
