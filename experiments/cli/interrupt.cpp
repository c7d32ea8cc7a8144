#include "experiments/cli/interrupt.h"

namespace twintrace {
namespace {

// A signal handler has no arguments to get its state from: the one global of the program.
volatile std::sig_atomic_t interruptRequested = 0;

void requestInterrupt(int) {
  interruptRequested = 1;
}

}  // namespace

InterruptScope::InterruptScope() {
  interruptRequested = 0;
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
  return interruptRequested != 0;
}

}  // namespace twintrace
