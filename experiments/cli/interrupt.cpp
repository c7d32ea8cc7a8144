#include "experiments/cli/interrupt.h"

#include <atomic>

namespace twintrace {
namespace {

// A signal handler has no arguments to get its state from: the one global of the program. Atomic, since
// the signal may come to any thread; without a lock, since a handler must not wait.
std::atomic<bool> interruptRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void requestInterrupt(int) {
  interruptRequested = true;
}

}  // namespace

InterruptScope::InterruptScope() {
  interruptRequested = false;
  struct sigaction action {};
  action.sa_handler = requestInterrupt;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &previous_);
}

InterruptScope::~InterruptScope() {
  sigaction(SIGINT, &previous_, nullptr);
}

bool InterruptScope::interrupted() const {
  return interruptRequested;
}

}  // namespace twintrace
