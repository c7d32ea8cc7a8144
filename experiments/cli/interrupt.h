#pragma once

#include <csignal>

namespace twintrace {

/// While it lives, the first Ctrl-C only asks the job to end after the frame under way; a second
/// one kills the program as usual. One at a time.
class InterruptScope {
 public:
  InterruptScope();
  ~InterruptScope();
  InterruptScope(const InterruptScope&) = delete;
  InterruptScope& operator=(const InterruptScope&) = delete;

  bool interrupted() const;

 private:
  struct sigaction previous_ {};
};

}  // namespace twintrace
