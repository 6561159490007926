#include "core/base/context.h"

#include <algorithm>
#include <thread>

#include "core/base/check_option.h"

namespace octacut {

Context::Context(int num_threads,
                 ProgressSink* sink,
                 const std::atomic<bool>* cancelled,
                 uint64_t seed)
    : num_threads_(num_threads),
      sink_(sink),
      cancelled_(cancelled),
      seed_(seed) {
  // A system does not make any number of threads.
  constexpr int kMaxThreads = 1024;
  CheckOption(
      num_threads == -1 || (num_threads >= 1 && num_threads <= kMaxThreads),
      "num_threads",
      num_threads,
      "must be -1 (all cores), or in 1 .. 1024");
  if (num_threads_ == -1) {
    num_threads_ = std::max(1u, std::thread::hardware_concurrency());
  }
}

void Context::ThrowIfCancelled() const {
  if (IsCancelled()) {
    throw CancelledError();
  }
}

void Context::Info(std::string_view message) const {
  if (sink_ != nullptr) {
    sink_->Info(message);
  }
}

void Context::Warn(std::string_view message) const {
  if (sink_ != nullptr) {
    sink_->Warn(message);
  }
}

Phase::Phase(const Context& context, std::string_view name, size_t total)
    : context_(context) {
  context_.ThrowIfCancelled();
  if (context_.Sink() != nullptr) {
    context_.Sink()->BeginPhase(name, total);
  }
}

Phase::~Phase() {
  if (context_.Sink() != nullptr) {
    context_.Sink()->EndPhase();
  }
}

void Phase::Advance(size_t count) {
  const size_t done = done_.fetch_add(count) + count;
  context_.ThrowIfCancelled();
  // A thread that finds another one reporting goes on: a later call reports.
  if (context_.Sink() != nullptr && !reporting_.test_and_set()) {
    context_.Sink()->Advance(done);
    reporting_.clear();
  }
}

}  // namespace octacut
