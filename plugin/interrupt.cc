#include "plugin/interrupt.h"

#include <csignal>

namespace octacut {
namespace {

// A handler reaches nothing but static storage.
std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void SetAction(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  // The second signal, of either kind, finds the default action: the handler
  // restores it for both.
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void HandleSignal(int /*signal*/) {
  requested.store(true);
  SetAction(SIG_DFL);
}

}  // namespace

InterruptHandler::InterruptHandler() {
  requested.store(false);
  SetAction(&HandleSignal);
}

InterruptHandler::~InterruptHandler() { SetAction(SIG_DFL); }

const std::atomic<bool>& InterruptHandler::Requested() const {
  return requested;
}

}  // namespace octacut
