// What a step may ask of the run it is part of: progress, cancellation, the
// number of threads, the seed. One object a run, passed by reference; there
// is no global state.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace octacut {

// Receives progress. Called from one thread at a time.
class ProgressSink {
 public:
  virtual ~ProgressSink() = default;
  // A phase begins; its work is `total` units (0: unknown).
  virtual void BeginPhase(std::string_view name, size_t total) = 0;
  // `done` units of the current phase are finished.
  virtual void Advance(size_t done) = 0;
  virtual void EndPhase() = 0;
  // A line for the user that is no error.
  virtual void Info(std::string_view message) = 0;
  virtual void Warn(std::string_view message) = 0;
};

class Context {
 public:
  // `num_threads` as COLMAP has it: -1 means all cores. `sink` may be null;
  // it and `cancelled` (may be null too, set asynchronously) must outlive the
  // context.
  explicit Context(int num_threads = -1,
                   ProgressSink* sink = nullptr,
                   const std::atomic<bool>* cancelled = nullptr,
                   uint64_t seed = 0);

  int NumThreads() const { return num_threads_; }
  uint64_t Seed() const { return seed_; }

  bool IsCancelled() const {
    return cancelled_ != nullptr && cancelled_->load(std::memory_order_relaxed);
  }
  // Throws CancelledError once the run is to stop. Cheap: ask it every few
  // milliseconds of work.
  void ThrowIfCancelled() const;

  void Info(std::string_view message) const;
  void Warn(std::string_view message) const;

  ProgressSink* Sink() const { return sink_; }

 private:
  int num_threads_;
  ProgressSink* sink_;
  const std::atomic<bool>* cancelled_;
  uint64_t seed_;
};

// A phase of work in scope: begins on construction, ends on destruction.
// Advance may be called from any thread.
class Phase {
 public:
  Phase(const Context& context, std::string_view name, size_t total = 0);
  ~Phase();
  Phase(const Phase&) = delete;
  Phase& operator=(const Phase&) = delete;

  // Reports `count` more finished units and throws CancelledError when the
  // run is to stop.
  void Advance(size_t count = 1);

 private:
  const Context& context_;
  std::atomic<size_t> done_{0};
  std::atomic_flag reporting_ = ATOMIC_FLAG_INIT;
};

}  // namespace octacut
