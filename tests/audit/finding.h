#pragma once

#include <string>

namespace twintrace::test {

/// What a check makes of a fault.
enum class Answer {
  notReached,  ///< nothing that the check runs reaches the fault
  no,          ///< it runs the fault and sees nothing
  yes
};

/// A check's answer and what it rests on, in words.
struct Finding {
  Answer answer = Answer::notReached;
  std::string detail;
};

}  // namespace twintrace::test
